# foverig_cuda_library(NAME FOLDER deps...): like foverig_library for a folder's *.cu, by the nvcc that
# DeviceCompiler found. Called as a command: CMake 3.25.1, Debian 12's, does not know C++20 for CUDA, and the
# flags of our C++ code, -march among them, must not reach what nvcc hands to the host's compiler.
# Beside each object lies OBJECT.ptxas, the assembler's report of registers, stack and spills.
set(FOVERIG_CUDA_ARCHS "90" CACHE STRING "GPU architectures to compile for: 75;86;89;90")
set(gencode)
foreach(arch IN LISTS FOVERIG_CUDA_ARCHS)
  list(APPEND gencode -gencode arch=compute_${arch},code=sm_${arch})
endforeach()
list(GET FOVERIG_CUDA_ARCHS -1 last_arch)    # its PTX too: a newer GPU's driver compiles that
list(APPEND gencode -gencode arch=compute_${last_arch},code=compute_${last_arch})
string(REPLACE ";" " sm_" FOVERIG_CUDA_FLAGS "-O3 sm_${FOVERIG_CUDA_ARCHS}")

find_package(Threads REQUIRED)

function(foverig_cuda_library name folder)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.cu)
  set(glm "$<TARGET_PROPERTY:glm::glm,INTERFACE_INCLUDE_DIRECTORIES>")
  set(include "$<IF:$<BOOL:${FOVERIG_CARRY}>,-isystem$<SEMICOLON>,-I>")    # /usr/include must be no -isystem
  set(objects)
  foreach(source IN LISTS sources)
    get_filename_component(stem ${source} NAME_WE)
    set(object ${PROJECT_BINARY_DIR}/cuda/${folder}/${stem}.o)
    # 20012: GLM marks defaulted functions. 554: nvcc reads a conversion that its constraint takes away.
    add_custom_command(OUTPUT ${object} BYPRODUCTS ${object}.ptxas DEPFILE ${object}.d
      COMMAND ${PROJECT_SOURCE_DIR}/cmake/keep_report ${object}.ptxas ${FOVERIG_NVCC} -std=c++20 -O3
        --expt-relaxed-constexpr -ccbin ${CMAKE_CXX_COMPILER} -diag-suppress 20012,554 -Xptxas -v ${gencode}
        -I ${PROJECT_SOURCE_DIR} "$<$<BOOL:${glm}>:${include}$<JOIN:${glm},;${include}>>"
        -MD -MF ${object}.d -MT ${object} -c -o ${object} ${source}
      DEPENDS ${source} ${PROJECT_SOURCE_DIR}/cmake/keep_report VERBATIM COMMAND_EXPAND_LISTS
      COMMENT "nvcc: ${folder}/${stem}")
    list(APPEND objects ${object})
  endforeach()
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/cuda/${folder})
  add_library(${name} STATIC EXCLUDE_FROM_ALL ${objects})
  set_target_properties(${name} PROPERTIES LINKER_LANGUAGE CXX)
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PUBLIC ${ARGN} ${FOVERIG_CUDART} Threads::Threads ${CMAKE_DL_LIBS} rt)
endfunction()
