#pragma once
// From the headset's bytes to the head's pose at a time to come.
#include <functional>
#include <optional>
#include <vector>

#include "devices/camera/head_camera.h"
#include "devices/dk2/imu_source.h"
#include "devices/fusion/tracked_head.h"
#include "devices/transport.h"
#include "rig/records/frame_record.h"
#include "rig/records/run_record.h"

namespace foverig {

/// The tracker camera that sees the headset.
struct CameraFeed {
    Transport* transport = nullptr;                ///< null: none
    std::function<void(const PoseFix&)> on_fix{};  ///< sees each pose before it is fused
};

class HeadTracker {
  public:
    /// Throws DeviceError where the headset does not answer. `transport` outlives the tracker.
    /// `on_sample` sees each sample before it is fused. With a `camera`, which outlives
    /// the tracker too, the headset's LEDs blink, and what it sees holds position and yaw.
    HeadTracker(Transport& transport, HostTime now, const HeadFusionConfig& config,
                std::function<void(const ImuSample&)> on_sample = {},
                const CameraFeed& camera = {});

    /// Takes all that arrived by `deadline`. A fault (unplugged) leaves the last pose standing.
    void read_until(HostTime deadline);

    Pose predict(HostTime time) const { return fusion_.at(time); }
    const std::optional<SampleInstants>& newest() const { return newest_; }
    std::vector<dk2::PanelReadback> take_panel_readbacks() {
        return source_.take_panel_readbacks();
    }
    const dk2::FactoryCalibration& calibration() const { return source_.calibration(); }
    DeviceRecord record() const;
    /// Why the camera could not be set up; null where it was, and without one.
    const Error* camera_as_it_is() const;
    /// Its lens is its own, as it told once, and not the design's.
    bool camera_calibrated() const { return camera_ && camera_->source().calibrated(); }
    /// Absent without a camera.
    std::optional<DeviceRecord> camera_record() const;

  private:
    void read_camera(HostTime deadline);

    std::unique_ptr<camera::HeadCamera> camera_;  // null: none
    dk2::Dk2ImuSource source_;
    TrackedHead fusion_;
    std::function<void(const ImuSample&)> on_sample_;
    std::function<void(const PoseFix&)> on_fix_;
    std::optional<HostTime> first_;
    std::optional<SampleInstants> newest_;
    std::optional<HostTime> first_fix_;
    std::optional<SampleInstants> newest_fix_;
};

}  // namespace foverig
