#pragma once
// Visibility rays of the three kinds of light, and what their answers add (Weier 2016 3.1).
// A ray of weight 0 is not traced.
#include "renderer/kernels/pixel.h"
#include "renderer/kernels/sampling.h"
#include "renderer/kernels/surface.h"
#include "renderer/scene/scene_view.h"
#include "renderer/trace/ray.h"

namespace foverig {

inline constexpr float kInversePi = 0.318309886184F;

/// Share of the way to a light that a shadow ray covers: it must end before the lamp's own surface.
inline constexpr float kShadowReach = 1.0F - 0x1.0p-12F;

/// Squared distance below which a light counts as being there: a micrometre, so that 1/d^2 stays
/// finite.
inline constexpr float kNearestLight2_m2 = 1.0e-12F;

/// Written number by number: copies of whole vectors keep a loop over lanes from being vectorised.
RIG_INLINE WeightedRay shadow_ray(const vec3& origin_m, float x, float y, float z, float weight) {
    WeightedRay r;
    r.ray.origin_m.x = origin_m.x;
    r.ray.origin_m.y = origin_m.y;
    r.ray.origin_m.z = origin_m.z;
    r.ray.direction.x = x;
    r.ray.direction.y = y;
    r.ray.direction.z = z;
    r.ray.t_max = kShadowReach;
    r.weight = weight;
    return r;
}

struct PointLightRays {
    Surfaces surfaces;
    PointLight light;

    RIG_HD WeightedRay operator()(int slot, int /*sample*/) const {
        const vec3 origin = surfaces.get3(Row::origin_x, slot);
        const vec3 normal = surfaces.get3(Row::normal_x, slot);
        const float x = light.position_m.x - origin.x;
        const float y = light.position_m.y - origin.y;
        const float z = light.position_m.z - origin.z;
        const float cosine = normal.x * x + normal.y * y + normal.z * z;
        return shadow_ray(origin, x, y, z, cosine > 0.0F ? 1.0F : 0.0F);
    }
};

struct StoreVisible {
    Surfaces surfaces;

    RIG_HD void operator()(int slot, float visible) const {
        surfaces.at(Row::visible, slot) = visible;
    }
};

/// Adds a point light where it is visible. Phong: kd/pi cos + ks cos^n of the mirrored direction,
/// times intensity over distance squared.
struct AddPointLight {
    Surfaces surfaces;
    PointLight light;

    RIG_HD void operator()(int slot) const {
        if (surfaces.at(Row::visible, slot) <= 0.0F) return;
        const vec3 to_light = light.position_m - surfaces.get3(Row::origin_x, slot);
        const float distance2 = max_of(glm::dot(to_light, to_light), kNearestLight2_m2);
        const vec3 direction = to_light * (1.0F / sqrtf(distance2));
        const vec3 normal = surfaces.get3(Row::normal_x, slot);
        const float cosine = glm::dot(normal, direction);
        vec3 reflected = surfaces.get3(Row::diffuse_r, slot) * (kInversePi * cosine);
        const vec3 specular = surfaces.get3(Row::specular_r, slot);
        if (specular.x + specular.y + specular.z > 0.0F) {
            const vec3 mirrored = 2.0F * cosine * normal - direction;
            const float lobe = glm::dot(mirrored, surfaces.get3(Row::view_x, slot));
            if (lobe > 0.0F) reflected += specular * powf(lobe, surfaces.at(Row::shininess, slot));
        }
        surfaces.set3(
            Row::colour_r, slot,
            surfaces.get3(Row::colour_r, slot) + reflected * light.intensity * (1.0F / distance2));
    }
};

struct AreaLightRays {
    Surfaces surfaces;
    View<const int> patterns;  ///< of each slot
    PatternTable points;       ///< rows: a, b in [0,1)
    AreaLight light;
    vec3 light_normal;   ///< unit
    float weight_scale;  ///< area / samples

    RIG_HD WeightedRay operator()(int slot, int sample) const {
        const int pattern = patterns[static_cast<std::size_t>(slot)];
        const float a = points.get(0, pattern, sample);
        const float b = points.get(1, pattern, sample);
        const vec3 origin = surfaces.get3(Row::origin_x, slot);
        const vec3 normal = surfaces.get3(Row::normal_x, slot);
        const float x = light.corner_m.x + a * light.edge_u_m.x + b * light.edge_v_m.x - origin.x;
        const float y = light.corner_m.y + a * light.edge_u_m.y + b * light.edge_v_m.y - origin.y;
        const float z = light.corner_m.z + a * light.edge_u_m.z + b * light.edge_v_m.z - origin.z;
        const float distance2 = max_of(x * x + y * y + z * z, kNearestLight2_m2);
        const float cosine = normal.x * x + normal.y * y + normal.z * z;
        const float light_cosine =
            fabsf(light_normal.x * x + light_normal.y * y + light_normal.z * z);
        return shadow_ray(
            origin, x, y, z,
            max_of(cosine, 0.0F) * light_cosine / (distance2 * distance2) * weight_scale);
    }
};

struct AddAreaLight {
    Surfaces surfaces;
    vec3 radiance;

    RIG_HD void operator()(int slot, float sum) const {
        surfaces.set3(Row::irradiance_r, slot,
                      surfaces.get3(Row::irradiance_r, slot) + radiance * sum);
    }
};

/// Table of cosine-weighted directions about +z: rows x, y, z.
RIG_INLINE WeightedRay occlusion_ray(const Surfaces& surfaces, int slot, int pattern,
                                     const PatternTable& directions, int sample, float reach_m) {
    const vec3 local{directions.get(0, pattern, sample), directions.get(1, pattern, sample),
                     directions.get(2, pattern, sample)};
    WeightedRay r;
    r.ray.origin_m = surfaces.get3(Row::origin_x, slot);
    r.ray.direction = frame_about(surfaces.get3(Row::normal_x, slot)).world(local);
    r.ray.t_max = reach_m;
    r.weight = 1.0F;
    return r;
}

/// Places of a queue (see OcclusionQueue), not slots, because the order of slots suits other rays.
struct OcclusionRays {
    Surfaces surfaces;
    View<const int> slots;     ///< of each place
    View<const int> patterns;  ///< of each place
    PatternTable directions;   ///< see occlusion_ray
    float reach_m;

    RIG_HD WeightedRay operator()(int place, int sample) const {
        return occlusion_ray(surfaces, slots[static_cast<std::size_t>(place)],
                             patterns[static_cast<std::size_t>(place)], directions, sample,
                             reach_m);
    }
};

/// Share of the hemisphere that is open.
struct StoreOcclusion {
    Surfaces surfaces;
    float inverse_samples;

    RIG_HD void operator()(int slot, float open) const {
        surfaces.at(Row::occlusion, slot) = open * inverse_samples;
    }
};

struct StoreOcclusionAt {
    StoreOcclusion store;
    View<const int> slots;  ///< of each place

    RIG_HD void operator()(int place, float open) const {
        store(slots[static_cast<std::size_t>(place)], open);
    }
};

}  // namespace foverig
