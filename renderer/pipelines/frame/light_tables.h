#pragma once
#include "renderer/effects/memory.h"
#include "renderer/kernels/sampling.h"

namespace foverig {

/// Sample points of one frame for every stochastic light, all patterns. Only what the plan has on
/// is allocated; `update` draws the frame's digit scrambles.
class LightTables {
  public:
    LightTables() = default;
    LightTables(EffectMemory& memory, const EffectPlan& plan, const Scene& scene,
                const LightingSettings& settings);

    void update(std::uint32_t seed, std::uint32_t frame);

    /// Rows a, b in [0,1)^2.
    PatternTable area(std::size_t light) const {
        return {area_points_.data() + light * area_floats(), area_samples_};
    }
    /// The tables of all area lights, one after the other.
    View<const float> areas() const { return area_points_.view(); }
    /// Rows x, y, z: cosine-weighted about +z.
    PatternTable occlusion() const { return {occlusion_.data(), occlusion_samples_}; }
    View<const float> occlusions() const { return occlusion_.view(); }

  private:
    std::size_t area_floats() const {
        return static_cast<std::size_t>(2 * kPatterns * area_samples_);
    }

    int area_samples_ = 0;
    int occlusion_samples_ = 0;
    Buffer<float> area_points_;
    Buffer<float> occlusion_;
};

}  // namespace foverig
