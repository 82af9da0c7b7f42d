#pragma once
#include "devices/hardware/live_transport.h"
#include "rig/session/simulated_world.h"

namespace foverig {

/// The devices on the desk; simulated ones stand in for what the scenario does not ask of the desk,
/// and the display is the scenario's virtual panel. The truth is known of simulated devices only.
class HardwareWorld final : public World {
  public:
    /// Throws DeviceError where a required device cannot be opened; otherwise as SimulatedWorld.
    /// `clock` runs in real time.
    HardwareWorld(const Scenario& scenario, Clock& clock,
                  const motion::EyeMotion* pointed_eyes = nullptr);

    Transport& headset() override;
    Transport& gaze_tracker() override;
    Display& display() override { return stand_ins_.display(); }
    Transport* tracker_camera() override;
    Transport* see_through_camera() override;

    double initial_yaw_rad() const override;
    std::optional<dquat> true_head(HostTime time) const override;
    std::optional<std::array<dvec3, 2>> true_gaze(HostTime time) const override;
    Origin origin(std::string_view device) const override;
    /// A headset on the desk reads its own panel, which does not show this run's frames.
    bool reads_back_our_frames() const override { return headset_ == nullptr; }
    bool at_end() const override { return false; }

  private:
    SimulatedWorld stand_ins_;
    bool simulated_see_through_;
    std::unique_ptr<hardware::LiveTransport> headset_, gaze_tracker_, camera_;  // null: simulated
};

}  // namespace foverig
