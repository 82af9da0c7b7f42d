#include "renderer/pipelines/light_tables.h"

namespace foverig {

LightTables::LightTables(EffectMemory& memory, const EffectPlan& plan, const Scene& scene,
                         const LightingSettings& settings) {
    if (plan.on(Effect::area_light)) {
        area_samples_ = settings.area_samples;
        for (std::size_t i = 0; i < scene.area_lights.size(); ++i)
            area_points_.emplace_back(memory.of(Effect::area_light),
                                      static_cast<std::size_t>(2 * kPatterns * area_samples_));
    }
    if (plan.on(Effect::ambient_occlusion)) {
        occlusion_samples_ = settings.ao_samples;
        occlusion_ = Buffer<float>(memory.of(Effect::ambient_occlusion),
                                   static_cast<std::size_t>(3 * kPatterns * occlusion_samples_));
    }
}

void LightTables::update(std::uint32_t seed, std::uint32_t frame) {
    const std::uint32_t frame_seed = hash32(seed, frame);
    for (std::size_t light = 0; light < area_points_.size(); ++light) {
        const std::uint32_t light_seed = hash32(frame_seed, static_cast<std::uint32_t>(light) + 1U);
        const std::size_t n = area_points_[light].size() / 2;
        for (std::size_t i = 0; i < n; ++i) {
            const vec2 p = scrambled_point(static_cast<std::uint32_t>(i), light_seed);
            area_points_[light][i] = p.x;
            area_points_[light][n + i] = p.y;
        }
    }
    const std::size_t n = occlusion_.size() / 3;
    for (std::size_t i = 0; i < n; ++i) {
        const vec3 direction =
            cosine_direction(scrambled_point(static_cast<std::uint32_t>(i), frame_seed));
        for (int axis = 0; axis < 3; ++axis)
            occlusion_[static_cast<std::size_t>(axis) * n + i] = direction[axis];
    }
}

}  // namespace foverig
