#pragma once
// The camera on the headset whose picture lies behind the rendered one.
#include <memory>

#include "devices/camera/video_camera.h"
#include "devices/display/display.h"
#include "rig/session/head_tracker.h"
#include "rig/session/world.h"

namespace foverig {

class SeeThrough {
  public:
    /// Null where the scenario asks for none. Throws DeviceError where it cannot be opened,
    /// UsageError where a simulated one has no simulated head to sit on. `world` and `clock` (the
    /// wall's) outlive this.
    static std::unique_ptr<SeeThrough> open(const Scenario& scenario, World& world, Clock& clock);

    /// The newest picture that arrived until now, for the head as it was then; absent: there is
    /// none (yet, or unplugged). It stands until the next call.
    std::optional<BehindPicture> picture(HostTime now, const HeadTracker& head);
    /// When that was exposed, and when it arrived.
    const std::optional<SampleInstants>& instants() const { return instants_; }

    DeviceRecord record() const;

  private:
    SeeThrough(const SeeThroughSettings& settings, std::unique_ptr<Transport> transport);

    SeeThroughSettings settings_;
    std::unique_ptr<Transport> transport_;
    camera::VideoCamera camera_;
    std::optional<SampleInstants> instants_;
    std::optional<HostTime> first_;   // shown, and ...
    std::uint64_t before_first_ = 0;  // ... how many came before it
    camera::AnyLens lens_;            // of the picture
    dquat world_from_camera_{1.0, 0.0, 0.0, 0.0};
};

}  // namespace foverig
