# foverig_build_info(TARGET): gives TARGET the definitions and the generated header that
# rig/identity/build_info.cpp reads. The commit is looked up at every build, the rest when configuring.
function(foverig_build_info target)
  set(folder ${PROJECT_BINARY_DIR}/generated)
  set(header ${folder}/foverig_git_commit.h)
  add_custom_target(foverig_git_identity
    COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -DOUTPUT=${header}
      -P ${PROJECT_SOURCE_DIR}/cmake/GitIdentity.cmake
    BYPRODUCTS ${header} VERBATIM)
  add_dependencies(${target} foverig_git_identity)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  get_directory_property(options COMPILE_OPTIONS)
  list(JOIN options " " options)
  string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} ${options}" flags)
  target_include_directories(${target} PRIVATE ${folder})
  target_compile_definitions(${target} PRIVATE
    FOVERIG_VERSION="${PROJECT_VERSION}"
    FOVERIG_BUILD_TYPE="${CMAKE_BUILD_TYPE}"
    FOVERIG_COMPILER="${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
    FOVERIG_FLAGS="${flags}")
endfunction()
