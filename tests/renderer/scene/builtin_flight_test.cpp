// The flights of the built-in scenes go through free space, along the curve that the rig flies.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "renderer/scene/library.h"

namespace foverig {
namespace {

/// Distance of p to a triangle, after Ericson, Real-Time Collision Detection, 5.1.5, by regions.
double distance_m(const dvec3& p, const dvec3& a, const dvec3& b, const dvec3& c) {
    const dvec3 ab = b - a;
    const dvec3 ac = c - a;
    const dvec3 n = glm::cross(ab, ac);
    const double n2 = glm::dot(n, n);
    const double v = glm::dot(glm::cross(p - a, ac), n) / n2;
    const double w = glm::dot(glm::cross(ab, p - a), n) / n2;
    if (v >= 0.0 && w >= 0.0 && v + w <= 1.0) return std::abs(glm::dot(p - a, n)) / std::sqrt(n2);
    const auto to_edge = [&](const dvec3& q, const dvec3& r) {
        const double t = std::clamp(glm::dot(p - q, r - q) / glm::dot(r - q, r - q), 0.0, 1.0);
        return glm::length(p - q - t * (r - q));
    };
    return std::min({to_edge(a, b), to_edge(b, c), to_edge(c, a)});
}

std::vector<dvec3> curve_through(const std::vector<CameraKey>& keys, int steps) {
    std::vector<dvec3> points;
    const auto last = static_cast<std::ptrdiff_t>(keys.size()) - 1;
    const auto key = [&](std::ptrdiff_t i) {
        return dvec3(
            keys[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, last))].position_m);
    };
    for (std::ptrdiff_t i = 0; i < last; ++i) {
        const dvec3 p0 = key(i - 1), p1 = key(i), p2 = key(i + 1), p3 = key(i + 2);
        for (int s = 0; s <= steps; ++s) {
            const double u = static_cast<double>(s) / steps;
            // Catmull-Rom, and the straight line between keys.
            points.push_back(0.5 * (2.0 * p1 + (p2 - p0) * u +
                                    (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3) * u * u +
                                    (3.0 * p1 - p0 - 3.0 * p2 + p3) * u * u * u));
            points.push_back(p1 + u * (p2 - p1));
        }
    }
    return points;
}

class BuiltinFlight : public testing::TestWithParam<const char*> {};

TEST_P(BuiltinFlight, KeepsAQuarterOfAMetreFromEverything) {
    constexpr float kClear_m = 0.25F;
    const Scene scene = make_builtin_scene(GetParam());
    const std::vector<dvec3> points = curve_through(scene.camera_path, 16);
    for (const uvec3& t : scene.triangles) {
        const vec3 a = scene.positions_m[t.x];
        const vec3 b = scene.positions_m[t.y];
        const vec3 c = scene.positions_m[t.z];
        const vec3 low = glm::min(a, glm::min(b, c)) - kClear_m;
        const vec3 high = glm::max(a, glm::max(b, c)) + kClear_m;
        for (const dvec3& point : points) {
            const vec3 p(point);
            if (glm::any(glm::lessThan(p, low)) || glm::any(glm::greaterThan(p, high))) continue;
            ASSERT_GE(distance_m(point, dvec3(a), dvec3(b), dvec3(c)), kClear_m)
                << p.x << ' ' << p.y << ' ' << p.z;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, BuiltinFlight,
                         testing::Values("cornell", "atrium", "tunnel-geom", "tunnel-maps",
                                         "voxel-town", "city"),
                         [](const auto& scene) {
                             std::string name = scene.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace foverig
