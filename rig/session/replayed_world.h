#pragma once
#include "rig/session/recorded_gaze.h"
#include "rig/session/recorded_origin.h"
#include "rig/session/world.h"
#include "simulators/panel/virtual_panel.h"
#include "simulators/replay/replayed_device.h"

namespace foverig {

/// The devices of a recording; the display is the scenario's virtual panel. Nobody knows the truth.
class ReplayedWorld final : public World {
  public:
    ReplayedWorld(const Scenario& scenario, Clock& clock);

    Transport& headset() override { return headset_; }
    Transport& gaze_tracker() override { return gaze_tracker_; }
    Display& display() override { return panel_; }
    Transport* tracker_camera() override { return camera_ ? &*camera_ : nullptr; }
    Transport* see_through_camera() override;

    double initial_yaw_rad() const override { return initial_yaw_rad_; }
    std::optional<dquat> true_head(HostTime) const override { return std::nullopt; }
    std::optional<std::array<dvec3, 2>> true_gaze(HostTime) const override { return std::nullopt; }
    std::optional<std::array<dvec3, 2>> best_known_gaze(HostTime time) const override {
        return recorded_gaze_.at(time);
    }
    Origin origin(std::string_view) const override { return Origin::recorded; }
    std::optional<Origin> recorded_from(std::string_view device) const override {
        return recorded_origin(recording_, device);
    }
    bool reads_back_our_frames() const override { return false; }
    bool at_end() const override;

  private:
    /// Throws InputError where the recording has nothing of that device.
    void require(const char* device, const char* what, const char* expected) const;

    Clock& clock_;
    bool sees_through_, loop_;
    Recording recording_;
    double initial_yaw_rad_;
    RecordedGaze recorded_gaze_;
    VirtualPanel panel_;
    ReplayedDevice headset_, gaze_tracker_;
    std::optional<ReplayedDevice> camera_, see_through_;
};

}  // namespace foverig
