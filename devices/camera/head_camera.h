#pragma once
// The tracker camera's whole way from bytes to the headset's pose before it.
#include <functional>
#include <memory>

#include "devices/camera/exposure_pairing.h"
#include "devices/camera/led_tracker.h"
#include "devices/camera/tracker_camera.h"
#include "devices/pose_fix.h"

namespace foverig::camera {

struct HeadCameraCounts {
    std::uint64_t unpaired = 0;  ///< frames of no known flash
    LedTrackerCounts tracker;
};

class HeadCamera {
  public:
    /// Where the sensor should be before the camera at an instant; nothing where nobody knows.
    using Expected = std::function<std::optional<RigidPose>(Dk2Time)>;

    /// Sets the camera to the headset's pulses. `transport` outlives this; `leds` are the
    /// headset's own. Errors as TrackerCamera's.
    static Result<std::unique_ptr<HeadCamera>> open(Transport& transport,
                                                    std::vector<dk2::Led> leds);

    /// Flashes that the headset told of; before the frames that show them are asked for.
    void add(std::span<const dk2::LedExposure> exposures);
    /// The next frame's pose, over frames without one. A fault leaves the camera to be asked again.
    Next<PoseFix> next(HostTime deadline, const Expected& expected);

    const TrackerCamera& source() const { return source_; }
    HeadCameraCounts counts() const { return {unpaired_, tracker_.counts()}; }

  private:
    HeadCamera(TrackerCamera source, std::vector<dk2::Led> leds);

    std::optional<PoseFix> fix_of(const CameraFrame& frame, const Expected& expected);

    TrackerCamera source_;
    ExposurePairing pairing_;
    LedTracker tracker_;
    std::optional<RigidPose> last_pose_;  // of the frame before; none where it had none
    std::uint64_t unpaired_ = 0;
};

}  // namespace foverig::camera
