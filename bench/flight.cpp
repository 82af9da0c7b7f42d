#include "bench/flight.h"

#include <cmath>
#include <numbers>

#include "renderer/kernels/sampling.h"

namespace foverig::bench {
namespace {

constexpr double kFixation_s = 0.3;

double degrees_of_sine(double amplitude_deg, double rate_hz, double time_s) {
    return amplitude_deg * std::sin(2.0 * std::numbers::pi * rate_hz * time_s);
}

dquat turn(double yaw_deg, double pitch_deg) {
    return glm::angleAxis(glm::radians(yaw_deg), dvec3(0.0, 1.0, 0.0)) *
           glm::angleAxis(glm::radians(pitch_deg), dvec3(1.0, 0.0, 0.0));
}

dvec3 gaze_at(double time_s) {
    const auto fixation = static_cast<std::uint32_t>(time_s / kFixation_s);
    const double yaw = 30.0 * unit_float(hash32(fixation, 1U)) - 15.0;
    const double pitch = 30.0 * unit_float(hash32(fixation, 2U)) - 15.0;
    return turn(yaw, pitch) * dvec3(0.0, 0.0, -1.0);
}

}  // namespace

Flight::Flight(const Scene& scene, const EyeSize& size)
    : path_(CameraSettings{}, scene), size_(size), one_way_s_(scene.camera_path_s) {}

int Flight::frame_count() const {
    return static_cast<int>(one_way_s_ * kRate_hz);
}

FrameInput Flight::frame(int index) const {
    const double time_s = index / kRate_hz;
    const Stand stand = path_.at(time_s);
    const dquat head = turn(degrees_of_sine(20.0, 0.4, time_s), degrees_of_sine(5.0, 0.23, time_s));
    FrameInput input;
    input.frame = static_cast<std::uint32_t>(index);
    input.time_s = time_s;
    EyeInput eye;
    // The DK2's frustum (DEVICES.md 2.2): left eye, outward tangent on the left.
    eye.view = {.width_px = size_.width_px,
                .height_px = size_.height_px,
                .tan_left = 1.058657F,
                .tan_right = 1.092368F,
                .tan_down = 1.331603F,
                .tan_up = 1.331603F,
                .position_m = vec3(stand.position_m),
                .world_from_eye = mat3(stand.world_from_body * glm::mat3_cast(head))};
    eye.gaze = vec3(gaze_at(time_s));
    input.eyes.push_back(eye);
    return input;
}

}  // namespace foverig::bench
