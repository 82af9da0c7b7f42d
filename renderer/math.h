#pragma once
#include "renderer/hd.h"

namespace foverig {

/// The smaller of two numbers, b if either is NaN. One instruction; fminf is a library call unless
/// NaNs are promised away.
RIG_INLINE float min_of(float a, float b) {
    return a < b ? a : b;
}
/// The larger of two numbers, b if either is NaN.
RIG_INLINE float max_of(float a, float b) {
    return a > b ? a : b;
}
RIG_INLINE float clamp_to(float x, float low, float high) {
    return min_of(max_of(x, low), high);
}

}  // namespace foverig
