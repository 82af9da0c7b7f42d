# Tests of the house itself, each a ctest house/NAME: what building the program would not notice. Those that
# compile do it through the build, so that only what changed is compiled again.
include(DeviceCompiler)

# Two builds of one folder must not run at once.
function(foverig_house_build_test name target)
  add_test(NAME house/${name}
    COMMAND ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --target ${target} --parallel 2)
  set_tests_properties(house/${name} PROPERTIES RESOURCE_LOCK build_folder TIMEOUT 900)
endfunction()

function(foverig_house_script_test name)
  add_test(NAME house/${name} COMMAND ${PROJECT_SOURCE_DIR}/tests/house/${name} ${ARGN}
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  set_tests_properties(house/${name} PROPERTIES SKIP_RETURN_CODE 77)
endfunction()

# A header compiles alone if some source includes it first, before anything that could help it. Sources
# do that with the header of their own name; every other header becomes a source of one line here.
function(foverig_header_test)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}
    renderer/*.h metrics/*.h devices/*.h simulators/*.h rig/*.h bench/*.h)
  set(alone)
  foreach(header IN LISTS headers)
    string(REGEX REPLACE "\\.h$" ".cpp" source ${header})
    if(EXISTS ${PROJECT_SOURCE_DIR}/${source})
      file(STRINGS ${PROJECT_SOURCE_DIR}/${source} first_include REGEX "^#include" LIMIT_COUNT 1)
      if(first_include STREQUAL "#include \"${header}\"")
        continue()
      endif()
    endif()
    set(one_line ${PROJECT_BINARY_DIR}/headers_alone/${source})
    file(CONFIGURE OUTPUT ${one_line} CONTENT "#include \"${header}\"\n" @ONLY)
    list(APPEND alone ${one_line})
  endforeach()
  add_library(headers_alone OBJECT EXCLUDE_FROM_ALL ${alone})
  target_link_libraries(headers_alone PRIVATE foverig_rig benchmark::benchmark foverig_warnings)
  foverig_house_build_test(headers headers_alone)
endfunction()

# What may become a kernel, compiled for the device: tests/house/device/*.cu launch each kernel. Compiled
# only; where there is no nvcc the test says that it is skipped.
function(foverig_device_test)
  if(NOT FOVERIG_NVCC)
    add_test(NAME house/kernels_for_device COMMAND ${CMAKE_COMMAND} -E echo "skipped: no nvcc here")
    set_tests_properties(house/kernels_for_device PROPERTIES SKIP_REGULAR_EXPRESSION "skipped")
    return()
  endif()
  file(GLOB sources CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} tests/house/device/*.cu)
  set(objects)
  foreach(source IN LISTS sources)
    get_filename_component(name ${source} NAME_WE)
    set(object ${PROJECT_BINARY_DIR}/kernels_for_device/${name}.o)
    # 20012: GLM marks defaulted functions. 554: nvcc reads a conversion that its constraint takes away.
    add_custom_command(OUTPUT ${object} DEPFILE ${object}.d
      COMMAND ${FOVERIG_NVCC} -std=c++20 --expt-relaxed-constexpr -ccbin ${CMAKE_CXX_COMPILER}
        -Werror all-warnings -diag-suppress 20012,554
        -gencode arch=compute_75,code=sm_75 -gencode arch=compute_90,code=sm_90
        -I ${PROJECT_SOURCE_DIR} -MD -MF ${object}.d -MT ${object} -c -o ${object} ${source}
      DEPENDS ${source} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM COMMENT "device: ${name}")
    list(APPEND objects ${object})
  endforeach()
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/kernels_for_device)
  set(in_all)
  if(FOVERIG_CUDA)
    set(in_all ALL)
  endif()
  add_custom_target(kernels_for_device ${in_all} DEPENDS ${objects})
  foverig_house_build_test(kernels_for_device kernels_for_device)
endfunction()

foverig_header_test()
foverig_device_test()
foverig_house_script_test(kernels_launched)
foverig_house_script_test(format)
foverig_house_script_test(includes)
foverig_house_script_test(paths)
foverig_house_script_test(duet $<TARGET_FILE:foverig>)
