#pragma once
// Rows of pixels in vectors: eight floats on the host, one on the device, with the same operators.
// Used where a loop's branches keep the compiler from vectorising it by itself.
#include <cstring>

#include "renderer/hd.h"

namespace foverig {

#if defined(__CUDACC__)

inline constexpr int kLanes = 1;
using Lanes = float;
using LaneMask = bool;

RIG_INLINE Lanes load_lanes(const float* p) {
    return *p;
}
RIG_INLINE void store_lanes(float* p, Lanes v) {
    *p = v;
}
RIG_INLINE Lanes lane_indices() {
    return 0.0F;
}
using LaneInts = int;
RIG_INLINE LaneInts truncate_lanes(Lanes v) {
    return static_cast<int>(v);
}
RIG_INLINE void store_lanes(int* p, LaneInts v) {
    *p = v;
}

#else

inline constexpr int kLanes = 8;
using Lanes = float __attribute__((vector_size(32)));
using LaneMask = int __attribute__((vector_size(32)));

RIG_INLINE Lanes load_lanes(const float* p) {
    Lanes v;
    std::memcpy(&v, p, sizeof v);
    return v;
}
RIG_INLINE void store_lanes(float* p, Lanes v) {
    std::memcpy(p, &v, sizeof v);
}
RIG_INLINE Lanes lane_indices() {
    return Lanes{0.0F, 1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F, 7.0F};
}
using LaneInts = LaneMask;
RIG_INLINE LaneInts truncate_lanes(Lanes v) {
    return __builtin_convertvector(v, LaneInts);
}
RIG_INLINE void store_lanes(int* p, LaneInts v) {
    std::memcpy(p, &v, sizeof v);
}

#endif

/// Smallest integers not below non-negative v.
RIG_INLINE LaneInts ceil_lanes(Lanes v) {
    const LaneInts whole = truncate_lanes(v);
#if defined(__CUDACC__)
    return whole + (static_cast<Lanes>(whole) < v ? 1 : 0);
#else
    return whole - (__builtin_convertvector(whole, Lanes) < v);  // a true lane is -1
#endif
}

RIG_INLINE Lanes sqrt_lanes(Lanes v) {
#if defined(__CUDACC__)
    return sqrtf(v);
#else
    Lanes r;
    for (int i = 0; i < kLanes; ++i) r[i] = __builtin_sqrtf(v[i]);
    return r;
#endif
}

RIG_INLINE Lanes select_lanes(LaneMask mask, Lanes a, Lanes b) {
    return mask ? a : b;
}
RIG_INLINE Lanes min_lanes(Lanes a, Lanes b) {
    return a < b ? a : b;
}
RIG_INLINE Lanes max_lanes(Lanes a, Lanes b) {
    return a > b ? a : b;
}

}  // namespace foverig
