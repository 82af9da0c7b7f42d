#pragma once
// A simulated DK2 and its simulated tracker camera on a manual clock, driven by their real sources.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "devices/camera/exposure_pairing.h"
#include "devices/camera/led_tracker.h"
#include "devices/camera/tracker_camera.h"
#include "devices/dk2/imu_source.h"
#include "devices/fusion/rotation.h"
#include "devices/head_geometry.h"
#include "simulators/camera/simulated_camera.h"
#include "simulators/dk2/simulated_dk2.h"
#include "simulators/motion/catalog.h"

namespace foverig::test {

/// A head whose neck sways from side to side besides.
class SwayingHead final : public motion::HeadMotion {
  public:
    SwayingHead(std::unique_ptr<motion::HeadMotion> head, double sway_m)
        : head_(std::move(head)), sway_m_(sway_m) {}
    motion::HeadState at(double t_s) const override {
        constexpr double kRate_rad_s = 2.0;
        motion::HeadState state = head_->at(t_s);
        state.position_m.x += sway_m_ * std::sin(kRate_rad_s * t_s);
        state.acceleration_m_s2.x -=
            sway_m_ * kRate_rad_s * kRate_rad_s * std::sin(kRate_rad_s * t_s);
        return state;
    }

  private:
    std::unique_ptr<motion::HeadMotion> head_;
    double sway_m_;
};

struct CameraRun {
    const char* motion = "still";
    CameraFaults faults{};
    Dk2Faults dk2{};
    RigidPose world_from_camera = usual_camera_place();
    camera::Lens lens{};
    bool yuyv = false;
    double sway_m = 0.0;
};

class CameraBench {
  public:
    explicit CameraBench(const CameraRun& run = {})
        : head(std::make_unique<SwayingHead>(std::move(motion::make_head(run.motion, 21)).value(),
                                             run.sway_m)),
          dk2(clock, *head, {.faults = run.dk2, .seed = 21}),
          leds(dk2::read_leds(dk2).value()),
          device(clock, *head, dk2,
                 {.world_from_camera = run.world_from_camera,
                  .lens = run.lens,
                  .leds = leds,
                  .faults = run.faults,
                  .seed = 21,
                  .yuyv = run.yuyv}),
          world_from_camera(run.world_from_camera) {}

    /// Where the sensor truly is before the camera.
    RigidPose truth(HostTime t) const {
        const auto state = head->at(to_seconds(t.time_since_epoch()));
        const RigidPose world_from_imu{state.world_from_head,
                                       state.position_m + state.world_from_head * kImuFromEyes_m};
        return world_from_camera.inverse() * world_from_imu;
    }

    ManualClock clock;
    std::unique_ptr<motion::HeadMotion> head;
    SimulatedDk2 dk2;
    std::vector<dk2::Led> leds;
    SimulatedCamera device;
    RigidPose world_from_camera;
};

inline HostTime at_s(double s) {
    return HostTime(from_seconds(s));
}

}  // namespace foverig::test
