# Tests of real drivers on the kernel's own devices, each folder of tests/kernel one program and one ctest of label
# `kernel`: a virtual machine with Debian's kernel (tests/kernel/judge; docs/kernel.md). One machine at a time, as each
# takes a core.
pkg_check_modules(openhmd QUIET IMPORTED_TARGET openhmd)

function(foverig_kernel_test name)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/kernel/${name}/*.cpp)
  add_executable(test_kernel_${name} ${sources})
  target_include_directories(test_kernel_${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_definitions(test_kernel_${name} PRIVATE FOVERIG_PROGRAM="$<TARGET_FILE:foverig>")
  target_compile_options(test_kernel_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  target_link_libraries(test_kernel_${name} PRIVATE ${ARGN} foverig_sim_replay GTest::gtest_main foverig_warnings)
  add_dependencies(test_kernel_${name} foverig)
  add_test(NAME kernel/${name} COMMAND ${PROJECT_SOURCE_DIR}/tests/kernel/judge
    ${PROJECT_BINARY_DIR}/kernel_vm ${PROJECT_BINARY_DIR}/kernel_vm/${name}
    $<TARGET_FILE:test_kernel_${name}> $<TARGET_FILE:foverig>)
  set_tests_properties(kernel/${name} PROPERTIES LABELS kernel RESOURCE_LOCK kernel_vm TIMEOUT 900)
endfunction()

# One test that says in a sentence what is wrong: `skipped` or `failed`, and why.
function(foverig_no_kernel_test name outcome why)
  add_test(NAME kernel/${name} COMMAND ${CMAKE_COMMAND} -E echo "${outcome}: ${why}")
  set_tests_properties(kernel/${name} PROPERTIES LABELS kernel
    SKIP_REGULAR_EXPRESSION "^skipped" FAIL_REGULAR_EXPRESSION "^failed")
endfunction()

if(CMAKE_CXX_FLAGS MATCHES "fsanitize")
  foverig_no_kernel_test(drivers skipped "a program with a sanitizer is too slow for a virtual machine's clock")
else()
  foverig_kernel_test(drivers foverig_hardware foverig_sim_usb foverig_sim_camera foverig_fusion)
  # OpenHMD brings hidapi over libusb, whose names are those of hidapi over hidraw: not in one program.
  if(openhmd_FOUND)
    foverig_kernel_test(peer foverig_dk2 foverig_fusion PkgConfig::openhmd)
  else()
    foverig_no_kernel_test(peer failed "no libopenhmd-dev here; scripts/install installs it")
  endif()
endif()
