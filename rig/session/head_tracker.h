#pragma once
// From the headset's bytes to the head's pose at a time to come.
#include <functional>
#include <optional>
#include <vector>

#include "devices/dk2/imu_source.h"
#include "devices/fusion/head_fusion.h"
#include "devices/transport.h"
#include "rig/records/frame_record.h"
#include "rig/records/run_record.h"

namespace foverig {

class HeadTracker {
  public:
    /// Throws DeviceError where the headset does not answer. `transport` outlives the tracker.
    /// `on_sample` sees each sample before it is fused.
    HeadTracker(Transport& transport, HostTime now, const HeadFusionConfig& config,
                std::function<void(const ImuSample&)> on_sample = {});

    /// Takes all that arrived by `deadline`. A fault (unplugged) leaves the last pose standing.
    void read_until(HostTime deadline);

    Pose predict(HostTime time) const { return fusion_.at(time); }
    const std::optional<SampleInstants>& newest() const { return newest_; }
    std::vector<dk2::PanelReadback> take_panel_readbacks() {
        return source_.take_panel_readbacks();
    }
    const dk2::FactoryCalibration& calibration() const { return source_.calibration(); }
    DeviceRecord record() const;

  private:
    dk2::Dk2ImuSource source_;
    HeadFusion fusion_;
    std::function<void(const ImuSample&)> on_sample_;
    std::optional<HostTime> first_;
    std::optional<SampleInstants> newest_;
};

}  // namespace foverig
