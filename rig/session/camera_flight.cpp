#include "rig/session/camera_flight.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/check.h"

namespace foverig {
namespace {

/// Catmull-Rom: through p1 (u = 0) and p2 (u = 1).
dvec3 between(const dvec3& p0, const dvec3& p1, const dvec3& p2, const dvec3& p3, double u) {
    return 0.5 * (2.0 * p1 + (p2 - p0) * u + (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3) * (u * u) +
                  (3.0 * p1 - p0 - 3.0 * p2 + p3) * (u * u * u));
}

/// The `i`-th point of a list of x, y, z in file coordinates, in the scene's.
vec3 point_of(const std::vector<double>& xyz, std::size_t i, const Scene& scene) {
    return vec3(dvec3(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]) - scene.origin_m);
}

Stand looking(const dvec3& position_m, const dvec3& target_m) {
    const dvec3 way = target_m - position_m;
    const dvec3 ahead = glm::length(way) > 1e-9 ? glm::normalize(way) : dvec3(0.0, 0.0, -1.0);
    // Straight up or down leaves no horizon: z then says where up points.
    const dvec3 up = std::abs(ahead.y) < 0.9999 ? dvec3(0.0, 1.0, 0.0) : dvec3(0.0, 0.0, 1.0);
    const dvec3 right = glm::normalize(glm::cross(ahead, up));
    return {position_m, dmat3(right, glm::cross(right, ahead), -ahead)};
}

}  // namespace

CameraFlight::CameraFlight(const CameraSettings& settings, const Scene& scene)
    : keys_(scene.camera_path), one_way_s_(std::max(1e-3, double{scene.camera_path_s})) {
    RIG_CHECK(!keys_.empty(), "a scene has at least one camera key");
    if (settings.one_way_s > 0.0) one_way_s_ = settings.one_way_s;
    if (settings.path == "keys") {
        keys_.clear();
        for (std::size_t i = 0; 6 * i < settings.keys_m.size(); ++i) {
            keys_.push_back({point_of(settings.keys_m, 2 * i, scene),
                             point_of(settings.keys_m, 2 * i + 1, scene)});
        }
    } else if (settings.path == "still") {
        keys_.resize(1);
        if (!settings.position_m.empty()) {
            keys_[0] = {point_of(settings.position_m, 0, scene),
                        point_of(settings.target_m, 0, scene)};
        }
    }
}

Stand CameraFlight::at(double time_s) const {
    const double along = 0.5 - 0.5 * std::cos(std::numbers::pi * time_s / one_way_s_);
    const auto last = static_cast<std::ptrdiff_t>(keys_.size()) - 1;
    const double place = along * static_cast<double>(last);
    const auto segment = std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(place), 0,
                                                    std::max<std::ptrdiff_t>(last - 1, 0));
    const double u = place - static_cast<double>(segment);
    const auto key = [&](std::ptrdiff_t i) -> const CameraKey& {
        return keys_[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, last))];
    };
    const auto through = [&](auto point) {
        return between(dvec3(point(key(segment - 1))), dvec3(point(key(segment))),
                       dvec3(point(key(segment + 1))), dvec3(point(key(segment + 2))), u);
    };
    return looking(through([](const CameraKey& k) { return k.position_m; }),
                   through([](const CameraKey& k) { return k.target_m; }));
}

}  // namespace foverig
