#pragma once
// The gaze tracker over a transport: Source<GazeSample>. Frames are timed by the device's own
// exposure stamps through the clock map, never by arrival. A tracker that was unplugged is set up
// and started again as soon as it answers. One thread uses it.
#include <array>
#include <optional>
#include <vector>

#include "devices/clock_map.h"
#include "devices/gaze/frame_sequence.h"
#include "devices/gaze/gaze_sample.h"
#include "devices/gaze/requests.h"
#include "devices/ring.h"
#include "devices/source.h"

namespace foverig::gaze {

/// A calibration that the host keeps for a tracker.
struct StoredCalibration {
    std::string serial;           ///< of the tracker that it is for
    std::vector<std::byte> blob;  ///< CAL_GET's answer, as CAL_SET takes it
};

struct GazeSourceConfig {
    std::uint16_t rate_hz = 60;  ///< 60, 120 or 250, where the device has it; 0: as it is set
    std::uint32_t options = option::events;          ///< SET_OPTIONS bits
    float mapping_mm = 1500;                         ///< +infinity: at the vergence distance
    std::optional<StoredCalibration> calibration{};  ///< set before each START; none: its own
    Nanoseconds time_sync_period{250'000'000};       ///< one GET_TIME round trip each
    ClockMapConfig clock_map{.window = Nanoseconds{1'000'000'000}, .windows = 30};
};

class GazeSource {
  public:
    using Sample = GazeSample;

    /// Checks the version, sets rate, options, mapping and calibration, starts a session.
    /// `transport` and `clock` outlive the source; the clock stamps GET_TIME round trips.
    static Result<GazeSource> open(Transport& transport, const Clock& clock,
                                   const GazeSourceConfig& config = {});

    Next<GazeSample> next(HostTime deadline);
    Status stop();

    /// Events since the last call; the newest 64 are kept.
    std::vector<EventFrame> take_events();
    /// What the tracker said of calibration and validation since the last call; the newest 64 are
    /// kept. They came before the sample that `next` gave last.
    std::vector<CalibrationFrame> take_calibrations();

    /// rejected: damaged, foreign, duplicate or late transfers. A damaged frame is also a lost one.
    SourceCounts counts() const { return counts_; }
    std::uint64_t missed_exposures() const { return missed_exposures_; }  ///< gaps in camera_frame
    std::uint32_t dropped_by_device() const { return dropped_by_device_; }
    const FailedRequests& failed_requests() const { return failed_requests_; }
    const ClockMap<GazeTime>& clock_map() const { return clock_map_; }
    const Info& info() const { return info_; }

  private:
    GazeSource(Transport& transport, const Clock& clock, const Info& info,
               const GazeSourceConfig& config);

    Status set_up();
    void set_up_again();
    void take(const Packet& packet);
    void take_sample(const SampleFrame& frame, HostTime arrival, bool gap);
    void follow_clock(const FrameHeader& header, HostTime arrival);
    void sync_time();

    Transport* transport_;
    const Clock* clock_;
    GazeSourceConfig config_;
    Info info_;
    ClockMap<GazeTime> clock_map_;
    FrameSequence sequence_;
    std::uint64_t last_queued_ns_ = 0;
    bool gap_before_next_sample_ = false;
    std::optional<std::uint32_t> last_camera_frame_;
    Ring<GazeSample> ready_;
    Ring<EventFrame> events_;
    Ring<CalibrationFrame> calibrations_;
    std::array<Nanoseconds, 40> round_trips_{};  // the newest, in any order
    std::size_t trips_ = 0;
    HostTime next_sync_{};
    std::optional<HostTime> next_set_up_;  // the tracker was gone: when to try
    std::uint16_t cookie_ = 0;
    SourceCounts counts_;
    FailedRequests failed_requests_;
    std::uint64_t missed_exposures_ = 0;
    std::uint32_t dropped_by_device_ = 0;
};

static_assert(Source<GazeSource>);

}  // namespace foverig::gaze
