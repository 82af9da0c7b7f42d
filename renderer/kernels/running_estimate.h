#pragma once
// How a new sample and the cache are weighed (Weier 2016 3.4, after Yang et al. 2009).
#include <cmath>
#include <cstdint>

#include "renderer/math.h"

namespace foverig {

/// k_t(dt) = min{exp(x0 + (dt - 1)/(t_max - 1) (x1 - x0)), k_max}, x = ln k: the smallest weight of
/// a new sample when the cached one is dt frames old. t_max = 1 leaves no range: any age weighs
/// k_max.
struct SmallestWeight {
    float log_k_min = 0.0F;
    float log_slope = 0.0F;  ///< per frame
    float k_max = 1.0F;

    SmallestWeight() = default;
    SmallestWeight(double k_min, double k_max_, int t_max)
        : log_k_min(static_cast<float>(std::log(t_max > 1 ? k_min : k_max_))),
          log_slope(t_max > 1
                        ? static_cast<float>((std::log(k_max_) - std::log(k_min)) / (t_max - 1))
                        : 0.0F),
          k_max(static_cast<float>(k_max_)) {}

    RIG_HD float operator()(std::uint32_t age_frames) const {
        return min_of(expf(log_k_min + log_slope * (static_cast<float>(age_frames) - 1.0F)), k_max);
    }
};

/// Weight of the new sample: alpha' = 1/(rho + 1), but at least k. The paper prints min{alpha', k};
/// its words
/// ("k is the minimum possible weight for the new sample") and Yang et al. ask for the maximum.
/// rho = 0 (never sampled) gives 1: the new sample alone.
RIG_INLINE float new_sample_weight(float rho, float k) {
    return max_of(1.0F / (rho + 1.0F), k);
}

/// Samples a pixel is worth after blending: (alpha^2 + (1 - alpha)^2 / rho)^-1; with rho = 0 or
/// alpha = 1, one.
RIG_INLINE float accumulated_samples(float rho, float alpha) {
    const float rest = 1.0F - alpha;
    return rho > 0.0F && rest > 0.0F ? 1.0F / (alpha * alpha + rest * rest / rho) : 1.0F;
}

/// Cache info of a pixel beside its colour (whose w holds rho): the frame it was last touched,
/// modulo 2^16. The paper also keeps alpha there, which nothing reads again once rho is known.
using CacheInfo = std::uint16_t;

RIG_INLINE CacheInfo touched_in(std::uint32_t frame) {
    return static_cast<CacheInfo>(frame & 0xFFFFU);
}

/// Frames since the pixel was touched, at least 1.
RIG_INLINE std::uint32_t age_frames(CacheInfo info, std::uint32_t frame) {
    const std::uint32_t age = (frame - info) & 0xFFFFU;
    return age > 0 ? age : 1U;
}

}  // namespace foverig
