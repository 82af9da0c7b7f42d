#pragma once
// Visibility rays of all kinds of light in one queue, and what their answers add together: on a GPU
// one long launch in place of several that each end on a few late rays.
#include "renderer/kernels/light_rays.h"

namespace foverig {

/// An area light as its rays want it.
struct Lamp {
    AreaLight light;
    vec3 normal{0.0F, 1.0F, 0.0F};  ///< unit
    float area_m2 = 0.0F;
    int table = 0;  ///< which of the tables of sample points is its own
};

/// Samples of a surface: first one a point light, then those of each lamp, then occlusion.
struct SecondarySamples {
    View<const PointLight> points;
    View<const Lamp> lamps;
    int area_samples = 0;  ///< of each lamp
    int ao_samples = 0;

    RIG_HD int points_end() const { return static_cast<int>(points.size); }
    RIG_HD int lamps_end() const {
        return points_end() + static_cast<int>(lamps.size) * area_samples;
    }
    RIG_HD int count() const { return lamps_end() + ao_samples; }
};

template <bool kArea, bool kOcclusion>
struct SecondaryRays {
    Surfaces surfaces;
    SecondarySamples samples;
    View<const int> patterns;  ///< of each slot
    const float* lamp_points;  ///< a PatternTable of two rows a lamp, one after the other
    const float* directions;   ///< see occlusion_ray
    float reach_m;             ///< of an occlusion ray

    RIG_HD WeightedRay operator()(int slot, int sample) const {
        if (sample < samples.points_end())
            return PointLightRays{surfaces, samples.points[static_cast<std::size_t>(sample)]}(slot,
                                                                                              0);
        if constexpr (kArea) {
            if (sample < samples.lamps_end()) {
                const int n = samples.area_samples;
                const int in_lamps = sample - samples.points_end();
                const Lamp& lamp = samples.lamps[static_cast<std::size_t>(in_lamps / n)];
                const PatternTable table{lamp_points + lamp.table * 2 * kPatterns * n, n};
                return AreaLightRays{surfaces,   patterns,    table,
                                     lamp.light, lamp.normal, lamp.area_m2 / static_cast<float>(n)}(
                    slot, in_lamps % n);
            }
        }
        if constexpr (kOcclusion)
            return occlusion_ray(surfaces, slot, patterns[static_cast<std::size_t>(slot)],
                                 {directions, samples.ao_samples}, sample - samples.lamps_end(),
                                 reach_m);
        return {};
    }
};

/// Adds a surface's light. `shares(sample)` is the weight of that ray where it is visible, else 0.
template <bool kArea, bool kOcclusion>
struct AddSecondary {
    Surfaces surfaces;
    SecondarySamples samples;

    template <class Shares>
    RIG_HD void operator()(int slot, const Shares& shares) const {
        for (int i = 0; i < samples.points_end(); ++i) {
            surfaces.at(Row::visible, slot) = shares(i);
            AddPointLight{surfaces, samples.points[static_cast<std::size_t>(i)]}(slot);
        }
        const auto sum = [&](int begin, int count) {
            float visible = 0.0F;
            for (int sample = begin; sample < begin + count; ++sample) visible += shares(sample);
            return visible;
        };
        if constexpr (kArea) {
            int begin = samples.points_end();
            for (const Lamp& lamp : samples.lamps) {
                AddAreaLight{surfaces, lamp.light.radiance}(slot, sum(begin, samples.area_samples));
                begin += samples.area_samples;
            }
        }
        if constexpr (kOcclusion)
            StoreOcclusion{surfaces, 1.0F / static_cast<float>(samples.ao_samples)}(
                slot, sum(samples.lamps_end(), samples.ao_samples));
    }
};

}  // namespace foverig
