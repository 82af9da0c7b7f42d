#pragma once
#include <vector>

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
        return {area_points_[light].data(), area_samples_};
    }
    /// Rows x, y, z: cosine-weighted about +z.
    PatternTable occlusion() const { return {occlusion_.data(), occlusion_samples_}; }

  private:
    int area_samples_ = 0;
    int occlusion_samples_ = 0;
    std::vector<Buffer<float>> area_points_;
    Buffer<float> occlusion_;
};

}  // namespace foverig
