#pragma once
// Powers without a library call and without a branch, so that a loop of them becomes vectors.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace foverig::metrics {

/// Base 2 logarithm of a normal x > 0, within 3e-7 absolute near 1 and 1e-7 relative far from it.
inline float log2_of(float x) {
    // Mantissa in [sqrt(1/2), sqrt(2)): the series of atanh then needs five terms.
    const auto shifted = static_cast<std::int32_t>(std::bit_cast<std::uint32_t>(x) - 0x3F3504F3U);
    const auto exponent = static_cast<float>(shifted >> 23);
    const float m = std::bit_cast<float>((shifted & 0x007FFFFF) + 0x3F3504F3);
    const float s = (m - 1.0F) / (m + 1.0F);
    const float s2 = s * s;
    const float series =
        1.0F + s2 * (0.333333333F + s2 * (0.2F + s2 * (0.142857143F + s2 * 0.111111111F)));
    return exponent + 2.88539008F * s * series;
}

/// 2 to the x, x clamped to [-126, 126], within 3e-7 relative.
inline float exp2_of(float x) {
    const float clamped = std::min(126.0F, std::max(-126.0F, x));
    const float whole = std::floor(clamped + 0.5F);
    const float f = (clamped - whole) * 0.693147181F;
    const float series =
        1.0F +
        f * (1.0F + f * (0.5F + f * (0.166666667F +
                                     f * (0.0416666667F +
                                          f * (0.00833333333F +
                                               f * (0.00138888889F + f * 0.000198412698F))))));
    const auto bits = (static_cast<std::int32_t>(whole) + 127) << 23;
    return series * std::bit_cast<float>(bits);
}

/// x to the p for p > 0: 0 where x <= 0 or x is NaN. Within 1e-6 relative where the result is
/// between 1e-3 and 1e3.
inline float power_of(float x, float p) {
    const float power = exp2_of(p * log2_of(x));
    return x > 0.0F ? power : 0.0F;
}

}  // namespace foverig::metrics
