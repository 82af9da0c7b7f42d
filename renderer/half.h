#pragma once
// Four halves in one 64-bit word: how images and caches keep colour (half the bandwidth of float).
#include <cstdint>
#include <cstring>

#include "renderer/vec.h"

#if defined(__CUDACC__)
#include <cuda_fp16.h>
#elif defined(__F16C__)
#include <immintrin.h>
#endif

namespace foverig {

struct Half4 {
    std::uint64_t bits = 0;  ///< x in the low 16 bits, then y, z, w
};

inline constexpr float kLargestHalf = 65504.0F;

/// A colour as halves can hold it: at most the largest, NaN as 0. Stored so, nothing that is mixed
/// later turns into infinity or NaN.
RIG_INLINE vec3 representable(const vec3& c) {
    const auto held = [](float v) {
        return v < kLargestHalf ? (v > 0.0F ? v : 0.0F) : (v == v ? kLargestHalf : 0.0F);
    };
    return {held(c.x), held(c.y), held(c.z)};
}

/// Round to nearest even; beyond kLargestHalf becomes infinity.
RIG_INLINE Half4 pack_half4(const vec4& v) {
#if defined(__CUDACC__)
    Half4 h;
    const __half2 lo = __floats2half2_rn(v.x, v.y);
    const __half2 hi = __floats2half2_rn(v.z, v.w);
    memcpy(&h.bits, &lo, 4);
    memcpy(reinterpret_cast<char*>(&h.bits) + 4, &hi, 4);
    return h;
#elif defined(__F16C__)
    const __m128i packed = _mm_cvtps_ph(_mm_setr_ps(v.x, v.y, v.z, v.w), _MM_FROUND_TO_NEAREST_INT);
    return {static_cast<std::uint64_t>(_mm_cvtsi128_si64(packed))};
#else
    const _Float16 h[4] = {static_cast<_Float16>(v.x), static_cast<_Float16>(v.y),
                           static_cast<_Float16>(v.z), static_cast<_Float16>(v.w)};
    Half4 r;
    std::memcpy(&r.bits, h, 8);
    return r;
#endif
}

RIG_INLINE vec4 unpack_half4(Half4 h) {
#if defined(__CUDACC__)
    __half2 lo;
    __half2 hi;
    memcpy(&lo, &h.bits, 4);
    memcpy(&hi, reinterpret_cast<const char*>(&h.bits) + 4, 4);
    const float2 a = __half22float2(lo);
    const float2 b = __half22float2(hi);
    return {a.x, a.y, b.x, b.y};
#elif defined(__F16C__)
    alignas(16) float f[4];
    _mm_store_ps(f, _mm_cvtph_ps(_mm_cvtsi64_si128(static_cast<long long>(h.bits))));
    return {f[0], f[1], f[2], f[3]};
#else
    _Float16 f[4];
    std::memcpy(f, &h.bits, 8);
    return {static_cast<float>(f[0]), static_cast<float>(f[1]), static_cast<float>(f[2]),
            static_cast<float>(f[3])};
#endif
}

/// Four channels in one register, with + - * by number and by another.
#if defined(__F16C__) && !defined(__CUDACC__)
using Quad = float __attribute__((vector_size(16)));
RIG_INLINE Quad unpack_quad(const Half4& h) {
    return Quad(_mm_cvtph_ps(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(&h))));
}
RIG_INLINE vec4 to_vec4(Quad q) {
    return {q[0], q[1], q[2], q[3]};
}
#else
using Quad = vec4;
RIG_INLINE Quad unpack_quad(const Half4& h) {
    return unpack_half4(h);
}
RIG_INLINE vec4 to_vec4(const Quad& q) {
    return q;
}
#endif

/// Mean of kTaps texels whose indices lie `stride` apart: the four channels go through one
/// register.
template <int kTaps>
RIG_INLINE Half4 mean_half4(const Half4* image, const int* indices, int stride) {
#if defined(__F16C__) && !defined(__CUDACC__)
    const auto texel = [&](int k) {
        return _mm_cvtph_ps(
            _mm_loadl_epi64(reinterpret_cast<const __m128i*>(image + indices[k * stride])));
    };
    __m128 sum = texel(0);
    for (int k = 1; k < kTaps; ++k) sum = _mm_add_ps(sum, texel(k));
    if constexpr (kTaps > 1) sum = _mm_mul_ps(sum, _mm_set1_ps(1.0F / kTaps));
    return {static_cast<std::uint64_t>(
        _mm_cvtsi128_si64(_mm_cvtps_ph(sum, _MM_FROUND_TO_NEAREST_INT)))};
#else
    vec4 sum{0.0F};
    for (int k = 0; k < kTaps; ++k) sum += unpack_half4(image[indices[k * stride]]);
    return pack_half4(sum * (1.0F / kTaps));
#endif
}

}  // namespace foverig
