#pragma once
// Bytes as lanes: what a node's rows are read into.
#include <cstdint>

#include "renderer/lanes.h"

#if defined(__AVX2__) && !defined(__CUDACC__)
#include <immintrin.h>
#endif

namespace foverig {

#if defined(__CUDACC__)

RIG_INLINE LaneInts load_byte_lanes(const std::uint8_t* p) {
    return *p;
}
RIG_INLINE Lanes to_floats(LaneInts v) {
    return static_cast<float>(v);
}
/// a * b + c, rounded once.
RIG_INLINE Lanes fused_lanes(Lanes a, float b, float c) {
    return __builtin_fmaf(a, b, c);
}
/// v where the mask holds, else 0.
RIG_INLINE LaneInts keep_lanes(LaneMask mask, LaneInts v) {
    return mask ? v : 0;
}
/// All lanes or-ed.
RIG_INLINE std::uint32_t union_of(LaneInts v) {
    return static_cast<std::uint32_t>(v);
}

#else

RIG_INLINE LaneInts load_byte_lanes(const std::uint8_t* p) {
#if defined(__AVX2__)
    const __m128i bytes = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(p));
    return LaneInts(_mm256_cvtepu8_epi32(bytes));  // one instruction
#else
    using Bytes = std::uint8_t __attribute__((vector_size(8)));
    Bytes bytes;
    std::memcpy(&bytes, p, sizeof bytes);
    return __builtin_convertvector(bytes, LaneInts);
#endif
}
RIG_INLINE Lanes to_floats(LaneInts v) {
    return __builtin_convertvector(v, Lanes);
}
RIG_INLINE Lanes fused_lanes(Lanes a, float b, float c) {
    Lanes r;
    for (int i = 0; i < kLanes; ++i) r[i] = __builtin_fmaf(a[i], b, c);
    return r;
}
RIG_INLINE LaneInts keep_lanes(LaneMask mask, LaneInts v) {
    return mask & v;
}
RIG_INLINE std::uint32_t union_of(LaneInts v) {
    using Four = int __attribute__((vector_size(16)));
    Four low;
    Four high;
    std::memcpy(&low, &v, sizeof low);
    std::memcpy(&high, reinterpret_cast<const char*>(&v) + sizeof low, sizeof high);
    low |= high;
    low |= __builtin_shufflevector(low, low, 2, 3, 0, 1);
    low |= __builtin_shufflevector(low, low, 1, 0, 3, 2);
    return static_cast<std::uint32_t>(low[0]);
}

#endif

}  // namespace foverig
