#pragma once
// From the gaze tracker's bytes to where each eye looks when the light comes.
#include <functional>
#include <optional>

#include "devices/gaze/gaze_filter.h"
#include "devices/gaze/gaze_source.h"
#include "devices/transport.h"
#include "rig/records/frame_record.h"
#include "rig/records/run_record.h"

namespace foverig {

class GazeTracker {
  public:
    /// Throws DeviceError where the tracker does not answer or cannot do what `config` asks. Both
    /// outlive this. `on_sample` sees each sample before it is filtered.
    GazeTracker(Transport& transport, const Clock& clock,
                std::function<void(const GazeSample&)> on_sample = {},
                const gaze::GazeSourceConfig& config = {});

    /// Takes all that arrived by `deadline`. A fault (unplugged) leaves the last gaze standing.
    void read_until(HostTime deadline);

    /// Where the eyes look in the head's frame, for light at `photon`, and how sure that is.
    FilteredGaze at(HostTime photon) const { return filter_.at(photon); }
    /// Newest sample in which an eye was seen.
    const std::optional<SampleInstants>& newest() const { return newest_; }
    const gaze::Info& info() const { return source_.info(); }
    DeviceRecord record() const;

  private:
    gaze::GazeSource source_;
    GazeFilter filter_;
    std::function<void(const GazeSample&)> on_sample_;
    std::optional<HostTime> first_;
    std::optional<SampleInstants> newest_;
    std::optional<SampleInstants> newest_any_;
};

}  // namespace foverig
