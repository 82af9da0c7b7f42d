#include "renderer/pipelines/frame/light_tables.h"

#include <algorithm>

namespace foverig {
namespace {

/// Which cell of a grid of `samples` cells over the unit square a point is in, quarter by quarter.
/// An aligned run of 2^m points of a (0,2)-sequence has one in each cell.
std::uint32_t cell_of(vec2 point, int samples) {
    std::uint32_t cell = 0;
    for (int cells = 1; cells < samples; cells *= 2) {
        point.x *= 2.0F;
        const bool upper = point.x >= 1.0F;
        point.x -= upper ? 1.0F : 0.0F;
        cell = 2 * cell + (upper ? 1U : 0U);
        std::swap(point.x, point.y);
    }
    return cell;
}

/// Points on a lamp, all patterns. Samples of a pattern are sorted by cell: those next to each
/// other lie near each other, and sample k lies in the same part of the lamp in every pattern.
std::vector<vec2> lamp_points(int samples, std::uint32_t seed) {
    std::vector<vec2> points(static_cast<std::size_t>(kPatterns * samples));
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i] = scrambled_point(static_cast<std::uint32_t>(i), seed);
    for (auto first = points.begin(); first != points.end(); first += samples)
        std::sort(first, first + samples, [&](const vec2& a, const vec2& b) {
            return cell_of(a, samples) < cell_of(b, samples);
        });
    return points;
}

}  // namespace

LightTables::LightTables(EffectMemory& memory, const EffectPlan& plan, const Scene& scene,
                         const LightingSettings& settings) {
    if (plan.on(Effect::area_light)) {
        area_samples_ = settings.area_samples;
        area_points_ =
            Buffer<float>(memory.of(Effect::area_light), scene.area_lights.size() * area_floats());
    }
    if (plan.on(Effect::ambient_occlusion)) {
        occlusion_samples_ = settings.ao_samples;
        occlusion_ = Buffer<float>(memory.of(Effect::ambient_occlusion),
                                   static_cast<std::size_t>(3 * kPatterns * occlusion_samples_));
    }
}

void LightTables::update(std::uint32_t seed, std::uint32_t frame) {
    const std::uint32_t frame_seed = hash32(seed, frame);
    for (std::size_t light = 0; light * area_floats() < area_points_.size(); ++light) {
        const std::uint32_t light_seed = hash32(frame_seed, static_cast<std::uint32_t>(light) + 1U);
        const std::vector<vec2> points = lamp_points(area_samples_, light_seed);
        float* const rows = area_points_.data() + light * area_floats();
        for (std::size_t i = 0; i < points.size(); ++i) {
            rows[i] = points[i].x;
            rows[points.size() + i] = points[i].y;
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
