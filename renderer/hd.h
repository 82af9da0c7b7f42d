#pragma once
// What a kernel may be compiled for. With nvcc, <cuda.h> must come before GLM.
#if defined(__CUDACC__)
#include <cuda.h>
#define RIG_HD __host__ __device__
#else
#define RIG_HD
#endif
#define RIG_INLINE RIG_HD inline __attribute__((always_inline))
