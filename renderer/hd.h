#pragma once
// What a kernel may be compiled for. With nvcc, <cuda.h> must come before GLM.
#if defined(__CUDACC__)
#include <cuda.h>
#define RIG_HD __host__ __device__
#else
#define RIG_HD
#endif
#define RIG_INLINE RIG_HD inline __attribute__((always_inline))

namespace foverig {

/// Adds 1 to what many kernels count in; on the device they do so at once.
RIG_INLINE void count_one(unsigned long& n) {
#if defined(__CUDA_ARCH__)
    static_assert(sizeof n == sizeof(unsigned long long));
    atomicAdd(reinterpret_cast<unsigned long long*>(&n), 1ULL);
#else
    ++n;
#endif
}

}  // namespace foverig
