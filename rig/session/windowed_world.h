#pragma once
#include "rig/session/live_parts.h"
#include "rig/session/world.h"

namespace foverig {

/// Another world's devices, with a window for the display.
class WindowedWorld final : public World {
  public:
    /// `reads_back`: the headset's panel is what the window fills.
    WindowedWorld(std::unique_ptr<World> devices, std::unique_ptr<Display> display, bool reads_back)
        : devices_(std::move(devices)), display_(std::move(display)), reads_back_(reads_back) {}

    Transport& headset() override { return devices_->headset(); }
    Transport& gaze_tracker() override { return devices_->gaze_tracker(); }
    Display& display() override { return *display_; }
    Transport* tracker_camera() override { return devices_->tracker_camera(); }
    Transport* see_through_camera() override { return devices_->see_through_camera(); }

    double initial_yaw_rad() const override { return devices_->initial_yaw_rad(); }
    std::optional<dquat> true_head(HostTime time) const override {
        return devices_->true_head(time);
    }
    std::optional<std::array<dvec3, 2>> true_gaze(HostTime time) const override {
        return devices_->true_gaze(time);
    }
    std::optional<std::array<dvec3, 2>> best_known_gaze(HostTime time) const override {
        return devices_->best_known_gaze(time);
    }
    Origin origin(std::string_view device) const override { return devices_->origin(device); }
    std::optional<Origin> recorded_from(std::string_view device) const override {
        return devices_->recorded_from(device);
    }
    bool reads_back_our_frames() const override { return reads_back_; }
    bool at_end() const override { return devices_->at_end(); }

  private:
    std::unique_ptr<World> devices_;
    std::unique_ptr<Display> display_;
    bool reads_back_;
};

}  // namespace foverig
