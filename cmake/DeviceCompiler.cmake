# Sets FOVERIG_NVCC to the CUDA compiler, or to FOVERIG_NVCC-NOTFOUND, and says which. CUDACXX names it,
# else PATH has it, else the toolkit lies where its installer puts it.
find_program(FOVERIG_NVCC NAMES "$ENV{CUDACXX}" nvcc PATHS /usr/local/cuda/bin DOC "CUDA compiler")
if(FOVERIG_NVCC)
  message(STATUS "nvcc: ${FOVERIG_NVCC}; tests compile the kernels for the device too")
elseif(FOVERIG_CUDA)
  message(FATAL_ERROR "FOVERIG_CUDA is ON and there is no nvcc: install the CUDA toolkit, set CUDACXX to "
    "its nvcc, or leave FOVERIG_CUDA OFF")
else()
  message(STATUS "nvcc: not found; the kernels are compiled for the host alone")
endif()
