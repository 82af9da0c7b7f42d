# Tests of the house itself: what the compiler of the program alone would not notice. Each is a ctest
# house/NAME. Those that compile do it through the build, so that only what changed is compiled again.
include(DeviceCompiler)

function(foverig_house_build_test name target)
  add_test(NAME house/${name}
    COMMAND ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --target ${target} --parallel 2)
  # Two builds of one folder must not run at once.
  set_tests_properties(house/${name} PROPERTIES RESOURCE_LOCK build_folder TIMEOUT 600)
endfunction()

# A header compiles alone if some source includes it first, before anything that could help it. Sources
# do that with the header of their own name; every other header is compiled by itself here.
function(foverig_header_test)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}
    renderer/*.h devices/*.h simulators/*.h rig/*.h bench/*.h)
  set(stamps)
  foreach(header IN LISTS headers)
    string(REGEX REPLACE "\\.h$" ".cpp" source ${header})
    if(EXISTS ${PROJECT_SOURCE_DIR}/${source})
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
      file(STRINGS ${PROJECT_SOURCE_DIR}/${source} includes REGEX "^#include" LIMIT_COUNT 1)
      if(includes STREQUAL "#include \"${header}\"")
        continue()
      endif()
    endif()
    set(stamp ${PROJECT_BINARY_DIR}/house/${header}.alone)
    get_filename_component(folder ${stamp} DIRECTORY)
    file(MAKE_DIRECTORY ${folder})
    add_custom_command(OUTPUT ${stamp} DEPFILE ${stamp}.d
      COMMAND ${CMAKE_CXX_COMPILER} -std=c++20 -march=${FOVERIG_ARCH} -fsyntax-only -I${PROJECT_SOURCE_DIR}
        "$<LIST:TRANSFORM,$<TARGET_PROPERTY:foverig_rig,INTERFACE_INCLUDE_DIRECTORIES>,PREPEND,-isystem>"
        -include ${header} -x c++ /dev/null -MD -MF ${stamp}.d -MT ${stamp}
      COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
      WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} COMMAND_EXPAND_LISTS VERBATIM
      COMMENT "${header} alone")
    list(APPEND stamps ${stamp})
  endforeach()
  add_custom_target(headers_alone DEPENDS ${stamps})
  foverig_house_build_test(headers headers_alone)
endfunction()
