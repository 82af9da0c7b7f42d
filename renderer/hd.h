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

/// The place before adding 1 to a count: a place of one's own in a list that many kernels fill.
RIG_INLINE int take_place(int& count) {
#if defined(__CUDA_ARCH__)
    return atomicAdd(&count, 1);
#else
    return count++;
#endif
}

/// What many kernels leave behind is the largest of all.
RIG_INLINE void keep_largest(unsigned long long& kept, unsigned long long value) {
#if defined(__CUDA_ARCH__)
    atomicMax(&kept, value);
#else
    if (value > kept) kept = value;
#endif
}

}  // namespace foverig
