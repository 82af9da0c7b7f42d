#pragma once
// A head that turns in place, the samples of an ideal sensor on it, and what a fusion makes of it.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "devices/fusion/head_fusion.h"
#include "devices/fusion/rotation.h"
#include "devices/head_geometry.h"

namespace foverig::test {

inline constexpr double kDeg = std::numbers::pi / 180;
inline constexpr dvec3 kUpright_m_s2{0, kGravity_m_s2, 0};

inline HostTime host(double s) {
    return HostTime(from_seconds(s));
}

/// A head turning in place; truth by integration 16 times finer than the samples.
struct TurningHead {
    std::function<dvec3(double)> rate_rad_s;  // in the head's frame
    dquat world_from_head{1, 0, 0, 0};
    double time_s = 0;

    void go_to(double end_s) {
        const int steps = std::max(1, static_cast<int>(std::lround((end_s - time_s) * 16000)));
        const double h = (end_s - time_s) / steps;
        for (int i = 0; i < steps; ++i) {
            const double t = time_s + i * h;
            world_from_head = glm::normalize(
                world_from_head * exp_map(rotation_of_rates(rate_rad_s(t), rate_rad_s(t + h), h)));
        }
        time_s = end_s;
    }
    ImuSample sample() const {
        ImuSample s;
        s.host_time = s.arrival = host(time_s);
        s.device_time = Dk2Time(from_seconds(1000 + time_s));
        s.sequence = static_cast<std::uint64_t>(std::lround(time_s * 1000));
        s.gyro_rad_s = rate_rad_s(time_s);
        s.accel_m_s2 = glm::conjugate(world_from_head) * kUpright_m_s2;
        return s;
    }
};

inline double error_deg(const HeadFusion& fusion, const TurningHead& head) {
    return angle_between(fusion.at(host(head.time_s)).world_from_head, head.world_from_head) / kDeg;
}

inline double tilt_error_deg(const HeadFusion& fusion, const TurningHead& head) {
    const dvec3 up = fusion.at(host(head.time_s)).world_from_head *
                     (glm::conjugate(head.world_from_head) * dvec3(0, 1, 0));
    return std::atan2(std::hypot(up.x, up.z), up.y) / kDeg;
}

}  // namespace foverig::test
