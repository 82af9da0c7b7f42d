# Sets FOVERIG_NVCC to the CUDA compiler and FOVERIG_CUDART to its runtime library, or FOVERIG_NVCC to
# FOVERIG_NVCC-NOTFOUND, and says which. CUDACXX names the compiler, else PATH has it, else the toolkit lies
# where its installer puts it. What PATH has may be a script that calls the compiler elsewhere, so the
# compiler itself is asked where its libraries lie.
find_program(FOVERIG_NVCC NAMES "$ENV{CUDACXX}" nvcc PATHS /usr/local/cuda/bin DOC "CUDA compiler")
set(no_nvcc "not found")
if(FOVERIG_NVCC)
  execute_process(COMMAND ${FOVERIG_NVCC} --dryrun -x cu -c /dev/null -o /dev/null
    OUTPUT_VARIABLE steps ERROR_VARIABLE steps)
  string(REGEX MATCH "LIBRARIES=[^\n]*" libraries "${steps}")
  string(REGEX MATCHALL "-L[^\" ]+" folders "${libraries}")
  list(TRANSFORM folders REPLACE "^-L" "")
  find_library(FOVERIG_CUDART cudart_static HINTS ${folders})
  if(NOT FOVERIG_CUDART)
    set(no_nvcc "${FOVERIG_NVCC} is there, its cudart_static is not")
    set(FOVERIG_NVCC FOVERIG_NVCC-NOTFOUND)
  endif()
endif()
if(FOVERIG_NVCC)
  message(STATUS "nvcc: ${FOVERIG_NVCC}; tests compile the kernels for the device too")
elseif(FOVERIG_CUDA)
  message(FATAL_ERROR "FOVERIG_CUDA is ON and there is no nvcc (${no_nvcc}): install the CUDA toolkit, set "
    "CUDACXX to its nvcc, or leave FOVERIG_CUDA OFF")
else()
  message(STATUS "nvcc: ${no_nvcc}; the kernels are compiled for the host alone")
endif()
