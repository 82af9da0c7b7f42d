#pragma once
// The camera on the headset whose picture lies behind the rendered one.
#include "devices/camera/video_camera.h"
#include "devices/display/display.h"
#include "rig/scenario/scenario.h"
#include "rig/session/head_tracker.h"

namespace foverig {

class SeeThrough {
  public:
    /// `camera` outlives this.
    SeeThrough(const SeeThroughSettings& settings, Transport& camera)
        : settings_(settings), camera_(camera) {}

    /// Takes all frames that arrived by `deadline`; none is converted.
    void read_until(HostTime deadline);

    /// Of the newest frame, for the head as it was then; absent: there is none (yet, or unplugged).
    /// It stands until the next call.
    std::optional<BehindPicture> picture(const HeadTracker& head);
    /// When the newest frame was exposed, and when it arrived.
    const std::optional<SampleInstants>& instants() const { return instants_; }

    DeviceRecord record() const;

  private:
    SeeThroughSettings settings_;
    camera::VideoCamera camera_;
    std::optional<SampleInstants> instants_;
    std::optional<HostTime> first_;   // read, and ...
    std::uint64_t before_first_ = 0;  // ... how many came before it
    bool shown_ = false;              // the newest, in the picture before
    camera::AnyLens lens_;            // of that picture
    dquat world_from_camera_{1.0, 0.0, 0.0, 0.0};
};

}  // namespace foverig
