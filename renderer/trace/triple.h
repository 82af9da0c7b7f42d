#pragma once
// One number for each corner of a triangle: four floats of a vector register on the host, the last
// unused; three floats on the device. Products and sums round the same on both: what is fused and
// what is not is written down, never left to the compiler.
#include "renderer/vec.h"

namespace foverig {

#if defined(__x86_64__)
#define RIG_IN_VECTOR_REGISTER "+x"
#else
#define RIG_IN_VECTOR_REGISTER "+w"
#endif

/// a * b, rounded before anything is added to it.
RIG_INLINE float rounded_product(float a, float b) {
#if defined(__CUDA_ARCH__)
    return __fmul_rn(a, b);
#else
    float product = a * b;
    asm("" : RIG_IN_VECTOR_REGISTER(product));
    return product;
#endif
}

#if defined(__CUDACC__)

using Triple = vec3;

RIG_INLINE Triple load_triple(const float* row) {
    const float4 v = *reinterpret_cast<const float4*>(row);
    return {v.x, v.y, v.z};
}
/// (b, c, a) of (a, b, c).
RIG_INLINE Triple next_corner(const Triple& v) {
    return {v.y, v.z, v.x};
}
/// (c, a, b) of (a, b, c).
RIG_INLINE Triple previous_corner(const Triple& v) {
    return {v.z, v.x, v.y};
}
/// scale * a + b, rounded once.
RIG_INLINE Triple fused(float scale, const Triple& a, const Triple& b) {
    return {__builtin_fmaf(scale, a.x, b.x), __builtin_fmaf(scale, a.y, b.y),
            __builtin_fmaf(scale, a.z, b.z)};
}
RIG_INLINE Triple fused(const Triple& a, const Triple& b, const Triple& c) {
    return {__builtin_fmaf(a.x, b.x, c.x), __builtin_fmaf(a.y, b.y, c.y),
            __builtin_fmaf(a.z, b.z, c.z)};
}
/// Bit i: corner i's number is below 0.
RIG_INLINE unsigned negative_corners(const Triple& v) {
    return (v.x < 0.0F ? 1U : 0U) | (v.y < 0.0F ? 2U : 0U) | (v.z < 0.0F ? 4U : 0U);
}

#else

using Triple = float __attribute__((vector_size(16)));
using TripleInts = int __attribute__((vector_size(16)));

RIG_INLINE Triple load_triple(const float* row) {
    return *reinterpret_cast<const Triple*>(row);
}
RIG_INLINE Triple next_corner(Triple v) {
    return __builtin_shufflevector(v, v, 1, 2, 0, 3);
}
RIG_INLINE Triple previous_corner(Triple v) {
    return __builtin_shufflevector(v, v, 2, 0, 1, 3);
}
RIG_INLINE Triple fused(float scale, Triple a, Triple b) {
    Triple r;
    for (int i = 0; i < 4; ++i) r[i] = __builtin_fmaf(scale, a[i], b[i]);
    return r;
}
RIG_INLINE Triple fused(Triple a, Triple b, Triple c) {
    Triple r;
    for (int i = 0; i < 4; ++i) r[i] = __builtin_fmaf(a[i], b[i], c[i]);
    return r;
}
RIG_INLINE unsigned negative_corners(Triple v) {
    const TripleInts below = v < 0.0F;
#if defined(__x86_64__)
    return static_cast<unsigned>(__builtin_ia32_movmskps(reinterpret_cast<Triple>(below))) & 7U;
#else
    return (below[0] & 1U) | (below[1] & 2U) | (below[2] & 4U);
#endif
}

#endif

/// a * b - c * d to 1.5 ulp, so with its sign (Kahan; error bound by Jeannerod, Louvet and Muller
/// 2013).
RIG_INLINE Triple difference_of_products(const Triple& a, const Triple& b, const Triple& c,
                                         const Triple& d) {
    const Triple product = c * d;
    const Triple error = fused(-c, d, product);
    return fused(a, b, -product) + error;
}
#undef RIG_IN_VECTOR_REGISTER

}  // namespace foverig
