# What runs on a GPU: nothing here needs Embree, TBB, an image library or a window (scripts/gpu).
include(CudaLibrary)
foverig_cuda_library(foverig_cuda renderer/backends/cuda glm::glm foverig_host_bvh)
foverig_cuda_library(foverig_cuda_pipelines renderer/pipelines/cuda foverig_cuda foverig_frame)
foverig_cuda_library(foverig_gpu_suites bench/gpu foverig_cuda)

# The backend `cuda` of everything that renders, where there is nvcc.
if(TARGET foverig_pipelines)
  target_link_libraries(foverig_pipelines PUBLIC foverig_cuda_pipelines)
  target_compile_definitions(foverig_pipelines PRIVATE FOVERIG_HAS_CUDA)
endif()

file(GLOB gpu_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/bench/gpu/*.cpp)
add_executable(foverig_gpu EXCLUDE_FROM_ALL ${gpu_sources})
target_include_directories(foverig_gpu PRIVATE ${PROJECT_SOURCE_DIR})
target_compile_definitions(foverig_gpu PRIVATE FOVERIG_CUDA_FLAGS="${FOVERIG_CUDA_FLAGS}")
target_link_libraries(foverig_gpu PRIVATE foverig_gpu_suites foverig_cuda_pipelines foverig_cuda foverig_frame foverig_host_bvh
  foverig_effects foverig_identity CLI11::CLI11 nlohmann_json::nlohmann_json foverig_warnings)

# Built by a test, so that a build of everything costs no more where there is no GPU.
function(foverig_gpu_tests)
  if(FOVERIG_CUDA)
    set_target_properties(foverig_gpu PROPERTIES EXCLUDE_FROM_ALL OFF)
  endif()
  foverig_house_build_test(gpu_program foverig_gpu)
  set_tests_properties(house/gpu_program PROPERTIES FIXTURES_SETUP gpu_program)
  foverig_house_script_test(spills ${PROJECT_BINARY_DIR}/cuda)
  foverig_house_script_test(without_gpu ${PROJECT_BINARY_DIR}/foverig_gpu)
  set_tests_properties(house/spills house/without_gpu PROPERTIES FIXTURES_REQUIRED gpu_program)
endfunction()
