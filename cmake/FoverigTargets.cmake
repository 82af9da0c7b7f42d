# One static library per folder: foverig_library(NAME FOLDER deps...). Sources are what the folder
# holds, so that adding a file needs no edit here.
function(foverig_library name folder)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.cpp)
  if(sources)
    add_library(${name} STATIC ${sources})
    target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
    target_link_libraries(${name} PUBLIC ${ARGN} PRIVATE foverig_warnings)
  else()
    add_library(${name} INTERFACE)
    target_include_directories(${name} INTERFACE ${PROJECT_SOURCE_DIR})
    target_link_libraries(${name} INTERFACE ${ARGN})
  endif()
endfunction()

# foverig_test(FOLDER deps...): every *_test.cpp below tests/FOLDER in one program.
function(foverig_test folder)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${folder}/*.cpp)
  if(NOT sources)
    return()
  endif()
  string(REPLACE "/" "_" name ${folder})
  add_executable(test_${name} ${sources})
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_definitions(test_${name} PRIVATE FOVERIG_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  # Tests are compiled once and run once: most of their time is the compiler's.
  target_compile_options(test_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  target_link_libraries(test_${name} PRIVATE ${ARGN} GTest::gmock GTest::gtest_main foverig_warnings)
  gtest_discover_tests(test_${name} TEST_PREFIX "${name}/" DISCOVERY_TIMEOUT 60 ${test_properties})
endfunction()

# foverig_mock_test(FOLDER deps...): the same with umockdev in the kernel's place. Where it cannot be preloaded one test
# says that it is skipped, and why.
function(foverig_mock_test folder)
  if(umockdev_FOUND AND NOT CMAKE_CXX_FLAGS MATCHES "fsanitize")
    set(test_properties PROPERTIES ENVIRONMENT LD_PRELOAD=libumockdev-preload.so.0)
    foverig_test(${folder} PkgConfig::umockdev ${ARGN})
    return()
  endif()
  add_test(NAME ${folder}
    COMMAND ${CMAKE_COMMAND} -E echo "skipped: no libumockdev-dev, or a sanitizer that must be loaded first")
  set_tests_properties(${folder} PROPERTIES SKIP_REGULAR_EXPRESSION "skipped")
endfunction()
