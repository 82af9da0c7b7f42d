#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/scene/scene.h"

namespace foverig {

/// Irradiance at p, normal n, of a parallelogram of radiance 1 that lies wholly above p's horizon:
/// Lambert's polygon formula, E = 1/2 sum over edges of the angle an edge subtends times n . its
/// plane's normal.
inline double polygon_irradiance(const AreaLight& light, const dvec3& p, const dvec3& n) {
    const dvec3 c(light.corner_m);
    const dvec3 u(light.edge_u_m);
    const dvec3 v(light.edge_v_m);
    const std::array<dvec3, 4> corners{c - p, c + u - p, c + u + v - p, c + v - p};
    double sum = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        const dvec3& a = corners[i];
        const dvec3& b = corners[(i + 1) % 4];
        const dvec3 side = glm::cross(a, b);
        const double angle = std::atan2(glm::length(side), glm::dot(a, b));
        sum += angle * glm::dot(glm::normalize(side), n);
    }
    return 0.5 * std::abs(sum);
}

}  // namespace foverig
