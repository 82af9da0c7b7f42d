# What runs on a GPU: nothing here needs Embree, TBB, an image library or a window (scripts/gpu).
include(CudaLibrary)
add_library(foverig_light_tables STATIC EXCLUDE_FROM_ALL renderer/pipelines/light_tables.cpp)
target_link_libraries(foverig_light_tables PUBLIC foverig_effects PRIVATE foverig_warnings)
foverig_cuda_library(foverig_cuda renderer/backends/cuda glm::glm)
foverig_cuda_library(foverig_cuda_full renderer/pipelines/cuda foverig_cuda foverig_light_tables)

file(GLOB gpu_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/bench/gpu/*.cpp)
add_executable(foverig_gpu EXCLUDE_FROM_ALL ${gpu_sources})
target_include_directories(foverig_gpu PRIVATE ${PROJECT_SOURCE_DIR})
target_compile_definitions(foverig_gpu PRIVATE FOVERIG_CUDA_FLAGS="${FOVERIG_CUDA_FLAGS}")
target_link_libraries(foverig_gpu PRIVATE foverig_cuda_full foverig_cuda foverig_host_bvh foverig_effects
  foverig_identity foverig_light_tables CLI11::CLI11 nlohmann_json::nlohmann_json foverig_warnings)

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
