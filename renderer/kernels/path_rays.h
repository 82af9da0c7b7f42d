#pragma once
// The rays of a path tracer's passes: primary, onward, to lights, and for occlusion.
#include "renderer/kernels/camera_rays.h"
#include "renderer/kernels/light_rays.h"
#include "renderer/kernels/path_sampling.h"
#include "renderer/kernels/path_state.h"

namespace foverig {

/// Begins the path of each queued pixel anywhere in the pixel: a box filter.
struct BeginPaths {
    EyeRays eye;
    PathSampler sampler;
    PathStates paths;

    RIG_HD void operator()(int i) const {
        const auto path = static_cast<std::size_t>(i);
        const PackedPixel p = paths.pixels[path];
        const vec2 jitter = sampler.point(p, 0, kLensPair);
        paths.queue[path] = static_cast<std::uint32_t>(i);
        paths.origin_m[path] = eye.origin_m;
        paths.direction[path] = eye.direction(static_cast<float>(pixel_x(p)) + jitter.x,
                                              static_cast<float>(pixel_y(p)) + jitter.y);
        paths.throughput[path] = vec3(1.0F);
        paths.radiance[path] = vec3(0.0F);
        paths.mirrored[path] = 1;
    }
};

struct PathRays {
    PathStates paths;

    RIG_HD Ray operator()(int i) const {
        const std::size_t path = paths.path(i);
        Ray ray;
        ray.origin_m = paths.origin_m[path];
        ray.direction = paths.direction[path];
        return ray;
    }
};

/// Which path a surface slot belongs to, and the numbers it draws there.
struct VertexSampler {
    PathStates paths;
    View<const std::uint32_t> path_of;  ///< by slot
    PathSampler sampler;
    std::uint32_t bounce = 0;

    RIG_HD vec2 point(int slot, std::uint32_t dimension) const {
        return sampler.point(paths.pixels[path_of[static_cast<std::size_t>(slot)]], bounce,
                             dimension);
    }
};

/// Two rays a light: sample 0 to a point drawn on it, sample 1 in a direction drawn by the cosine,
/// if that meets it. By the balance heuristic (Veach and Guibas 1995) both weigh cos / (p_area +
/// p_cosine), densities per steradian: at most pi, so that a surface beside a lamp makes no
/// fireflies.
struct PathAreaLightRays {
    Surfaces surfaces;
    VertexSampler vertex;
    AreaLight light;
    vec3 light_normal;  ///< unit
    float area_m2;
    std::uint32_t dimension;

    static constexpr int kSamples = 2;

    /// Direction whose length reaches the light, or 0 where the drawn direction misses it.
    RIG_HD vec3 to_light(int slot, int sample, const vec3& origin, const vec3& normal) const {
        const vec2 p = vertex.point(slot, dimension + static_cast<std::uint32_t>(sample));
        if (sample == 0)
            return light.corner_m + p.x * light.edge_u_m + p.y * light.edge_v_m - origin;
        const vec3 direction = frame_about(normal).world(cosine_direction(p));
        const float along = glm::dot(direction, light_normal);
        const float t =
            glm::dot(light.corner_m - origin, light_normal) / (along != 0.0F ? along : 1.0F);
        const vec3 in_plane = origin + t * direction - light.corner_m;
        const float a = glm::dot(glm::cross(in_plane, light.edge_v_m), light_normal) / area_m2;
        const float b = glm::dot(glm::cross(light.edge_u_m, in_plane), light_normal) / area_m2;
        const bool met =
            along != 0.0F && t > 0.0F && a >= 0.0F && a < 1.0F && b >= 0.0F && b < 1.0F;
        return met ? t * direction : vec3(0.0F);
    }

    RIG_HD WeightedRay operator()(int slot, int sample) const {
        const vec3 origin = surfaces.get3(Row::origin_x, slot);
        const vec3 normal = surfaces.get3(Row::normal_x, slot);
        const vec3 d = to_light(slot, sample, origin, normal);
        const float distance2 = max_of(glm::dot(d, d), kNearestLight2_m2);
        const float inverse_distance = 1.0F / sqrtf(distance2);
        const float cosine = max_of(glm::dot(normal, d), 0.0F) * inverse_distance;
        const float light_cosine = fabsf(glm::dot(light_normal, d)) * inverse_distance;
        // cos / (distance2 / (light_cosine area) + cos / pi), with no division by a light seen
        // edge-on.
        const float lit_area_m2 = light_cosine * area_m2;
        return shadow_ray(origin, d.x, d.y, d.z,
                          cosine * lit_area_m2 / (distance2 + cosine * kInversePi * lit_area_m2));
    }
};

struct PathOcclusionRays {
    Surfaces surfaces;
    VertexSampler vertex;
    float reach_m;

    RIG_HD WeightedRay operator()(int slot, int /*sample*/) const {
        WeightedRay r;
        r.ray.origin_m = surfaces.get3(Row::origin_x, slot);
        r.ray.direction = frame_about(surfaces.get3(Row::normal_x, slot))
                              .world(cosine_direction(vertex.point(slot, kOcclusionPair)));
        r.ray.t_max = reach_m;
        r.weight = 1.0F;
        return r;
    }
};

}  // namespace foverig
