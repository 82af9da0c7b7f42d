#pragma once
#include "rig/session/simulated_world.h"

namespace foverig::test {

/// A simulated world, devices of which a test puts others in the place of.
class AlteredWorld final : public World {
  public:
    AlteredWorld(const Scenario& scenario, Clock& clock) : world_(scenario, clock) {}

    Transport* gaze_instead = nullptr;  ///< null: the simulated one, as all others
    Transport* camera_instead = nullptr;

    SimulatedWorld& simulated() { return world_; }
    Transport& headset() override { return world_.headset(); }
    Transport& gaze_tracker() override {
        return gaze_instead != nullptr ? *gaze_instead : world_.gaze_tracker();
    }
    Display& display() override { return world_.display(); }
    Transport* tracker_camera() override {
        return camera_instead != nullptr ? camera_instead : world_.tracker_camera();
    }
    Transport* see_through_camera() override { return world_.see_through_camera(); }
    double initial_yaw_rad() const override { return world_.initial_yaw_rad(); }
    std::optional<dquat> true_head(HostTime time) const override { return world_.true_head(time); }
    std::optional<std::array<dvec3, 2>> true_gaze(HostTime time) const override {
        return world_.true_gaze(time);
    }
    Origin origin(std::string_view device) const override { return world_.origin(device); }
    bool reads_back_our_frames() const override { return true; }
    bool at_end() const override { return false; }

  private:
    SimulatedWorld world_;
};

}  // namespace foverig::test
