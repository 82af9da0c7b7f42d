#include "rig/live/gaze_ring.h"

#include <cmath>
#include <numbers>

namespace foverig {

std::vector<dvec2> gaze_ring(Eye eye, const dvec3& gaze, double radius_deg, const EyeMap& map) {
    constexpr int kPoints = 96;
    constexpr double kLeastAhead = 0.05;  // of a unit: flatter rays miss every lens
    const dvec3 aside = glm::normalize(glm::cross(gaze, dvec3(0.0, 1.0, 0.0)));
    const dvec3 up = glm::cross(aside, gaze);
    const double radius_rad = glm::radians(radius_deg);
    std::vector<dvec2> line;
    for (int i = 0; i <= kPoints; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / kPoints;
        const dvec3 ray = std::cos(radius_rad) * gaze +
                          std::sin(radius_rad) * (std::cos(turn) * aside + std::sin(turn) * up);
        if (-ray.z < kLeastAhead) continue;
        line.push_back(map.ndc(eye, dvec2(ray.x, ray.y) / -ray.z));
    }
    return line;
}

}  // namespace foverig
