#pragma once
// Everything that stands for hardware when `devices` is sim: a head, two eyes, a headset and a gaze
// tracker that speak bytes, a panel, and the truth to judge predictions by.
#include "rig/session/world.h"
#include "simulators/camera/simulated_camera.h"
#include "simulators/dk2/simulated_dk2.h"
#include "simulators/gaze/simulated_gaze.h"
#include "simulators/motion/eye_motion.h"
#include "simulators/motion/head_motion.h"
#include "simulators/panel/virtual_panel.h"

namespace foverig {

class SimulatedWorld final : public World {
  public:
    /// Throws UsageError for an unknown motion, InputError for a recording that cannot be read.
    /// `clock` outlives the world, and so do `pointed_eyes`, which motion.gaze = mouse needs.
    SimulatedWorld(const Scenario& scenario, Clock& clock,
                   const motion::EyeMotion* pointed_eyes = nullptr);

    Transport& headset() override { return headset_; }
    Transport& gaze_tracker() override { return gaze_tracker_; }
    Display& display() override { return panel_; }
    Transport* tracker_camera() override { return camera_ ? &*camera_ : nullptr; }
    Transport* see_through_camera() override;

    double initial_yaw_rad() const override;
    std::optional<dquat> true_head(HostTime time) const override;
    std::optional<std::array<dvec3, 2>> true_gaze(HostTime time) const override;
    /// All but a see-through camera of the desk.
    Origin origin(std::string_view device) const override;
    bool reads_back_our_frames() const override { return true; }
    bool at_end() const override { return false; }

  private:
    Clock& clock_;
    SeeThroughSettings see_through_settings_;
    std::unique_ptr<motion::HeadMotion> head_;
    std::unique_ptr<motion::EyeMotion> eyes_;  // null: pointed
    const motion::EyeMotion* pointed_eyes_;    // null: not pointed
    HostTime start_;
    VirtualPanel panel_;
    SimulatedDk2 headset_;
    SimulatedGaze gaze_tracker_;
    std::optional<SimulatedCamera> camera_;
    std::unique_ptr<Transport> see_through_;  // null: not opened
};

}  // namespace foverig
