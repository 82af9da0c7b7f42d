#pragma once
// Rays of the kinds that tracers are compared on; ray i of a kind is a hash of i.
#include <array>
#include <cmath>

#include "renderer/kernels/sampling.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/ray.h"

namespace foverig::bench {

enum class RayKind {
    primary,       ///< from the camera path
    diffuse,       ///< off a surface, by the cosine law
    axis_aligned,  ///< exactly along an axis, half of them in a plane of a vertex
    grazing,       ///< nearly within a triangle's plane
    inside         ///< from anywhere in the bounds to anywhere
};
inline constexpr std::array kRayKinds{RayKind::primary, RayKind::diffuse, RayKind::axis_aligned,
                                      RayKind::grazing, RayKind::inside};

inline const char* name_of(RayKind kind) {
    constexpr std::array kNames{"primary", "diffuse", "axis-aligned", "grazing", "inside"};
    return kNames[static_cast<std::size_t>(kind)];
}

class RayMaker {
  public:
    /// Borrows the scene, which has triangles and camera keys.
    explicit RayMaker(const Scene& scene) : scene_(scene) {}

    Ray operator()(RayKind kind, std::uint32_t i) const {
        const auto seed = 0x1000U * (static_cast<std::uint32_t>(kind) + 1U);
        const auto random = [=](std::uint32_t k) { return unit_float(hash32(i, seed + k)); };
        const vec3 point = in_bounds({random(0), random(1), random(2)});
        const Spot spot = spot_of(hash32(i, seed + 3), random(4), random(5));
        const vec3 sphere = on_sphere(random(6), random(7));
        Ray ray;
        switch (kind) {
            case RayKind::primary: {
                const auto keys = static_cast<std::uint32_t>(scene_.camera_path.size());
                const CameraKey& key = scene_.camera_path[hash32(i, seed + 8) % keys];
                ray.origin_m = key.position_m;
                const vec3 away = key.target_m - key.position_m;
                ray.direction = glm::normalize(away) + 0.8F * sphere;
                break;
            }
            case RayKind::diffuse: {
                const vec3 normal = random(8) < 0.5F ? spot.normal : -spot.normal;
                ray.origin_m = spot.point_m + 1.0e-4F * size_m() * normal;
                ray.direction = normal + 0.999F * sphere;
                break;
            }
            case RayKind::axis_aligned: {
                const int axis = static_cast<int>(hash32(i, seed + 8) % 3U);
                ray.origin_m = random(9) < 0.5F ? point : spot.corner_m;
                ray.origin_m[axis] = point[axis];
                ray.direction = vec3(0.0F);
                ray.direction[axis] = random(10) < 0.5F ? 1.0F : -1.0F;
                break;
            }
            case RayKind::grazing: {
                const vec3 along = glm::normalize(spot.corner_m - spot.point_m + 1.0e-3F * sphere);
                ray.direction = along + 1.0e-3F * (random(8) - 0.5F) * spot.normal;
                ray.origin_m = spot.point_m - (0.1F * size_m() * random(9)) * ray.direction;
                break;
            }
            case RayKind::inside:
                ray.origin_m = point;
                ray.direction = in_bounds({random(8), random(9), random(10)}) - point;
                break;
        }
        return ray;
    }

  private:
    struct Spot {
        vec3 point_m;
        vec3 corner_m;
        vec3 normal;  ///< unit, or 0 of a triangle without area
    };

    Spot spot_of(std::uint32_t hash, float a, float b) const {
        const uvec3 c = scene_.triangles[hash % scene_.triangles.size()];
        const vec3 p = scene_.positions_m[c.x];
        const vec3 u = scene_.positions_m[c.y] - p;
        const vec3 v = scene_.positions_m[c.z] - p;
        if (a + b > 1.0F) {
            a = 1.0F - a;
            b = 1.0F - b;
        }
        const vec3 normal = glm::cross(u, v);
        const float length = glm::length(normal);
        return {p + a * u + b * v, p, length > 0.0F ? normal * (1.0F / length) : vec3(0.0F)};
    }
    vec3 in_bounds(const vec3& unit) const {
        return scene_.bounds.min_m + unit * (scene_.bounds.max_m - scene_.bounds.min_m);
    }
    float size_m() const { return glm::length(scene_.bounds.max_m - scene_.bounds.min_m); }
    static vec3 on_sphere(float a, float b) {
        const float z = 2.0F * a - 1.0F;
        const float r = std::sqrt(max_of(0.0F, 1.0F - z * z));
        const float turn = 6.2831853F * b;
        return {r * std::cos(turn), r * std::sin(turn), z};
    }

    const Scene& scene_;
};

/// The scene in other units: lengths times `factor`. Lights and views are scaled as places are.
inline Scene scaled(Scene scene, float factor) {
    for (vec3& p : scene.positions_m) p *= factor;
    for (CameraKey& key : scene.camera_path) {
        key.position_m *= factor;
        key.target_m *= factor;
    }
    for (Motion& m : scene.motions) {
        m.pivot_m *= factor;
        m.swing_m *= factor;
    }
    update_bounds(scene);
    return scene;
}

}  // namespace foverig::bench
