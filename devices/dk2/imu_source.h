#pragma once
// The DK2 over a transport: Source<ImuSample>. Sets the device up, has whatever reads it keep it
// awake by report 17 (DEVICES.md 1.6), corrects a switch to report 1, and sets a headset up again
// that was unplugged. One thread uses it; it has none of its own.
#include <vector>

#include "devices/clock_map.h"
#include "devices/dk2/decoder.h"
#include "devices/dk2/feature_reports.h"
#include "devices/ring.h"
#include "devices/source.h"

namespace foverig::dk2 {

struct ImuSourceConfig {
    std::uint8_t interval = 0;  ///< reports at 1000 / (1 + interval) Hz
    bool read_pixel = true;     ///< turns the latency tester on
    /// Of the panel, as PanelTiming takes it: published ones disagree, and another program's stays.
    std::uint16_t persistence_rows = 435;
    bool light_leds = false;  ///< blinking, for the tracker camera
    std::uint16_t keep_alive_timeout_ms = 10000;
    Nanoseconds keep_alive_period{3'000'000'000};  ///< three tries a time-out, two with one lost
    ClockMapConfig clock_map{};
};

class Dk2ImuSource {
  public:
    using Sample = ImuSample;

    /// Reads the factory calibration and the gyro's offsets by temperature, takes them over from
    /// the device, selects report 11.
    /// `transport` outlives the source; no report came before `now`.
    static Result<Dk2ImuSource> open(Transport& transport, HostTime now,
                                     const ImuSourceConfig& config = {});

    /// Samples in order; up to 254 come of one packet.
    Next<ImuSample> next(HostTime deadline);

    /// Read-backs since the last call, one for each new frame count; the newest 64 are kept.
    std::vector<PanelReadback> take_panel_readbacks();

    /// Flashes of the LEDs since the last call, one for each new count; the newest 64 are kept.
    std::vector<LedExposure> take_exposures();

    SourceCounts counts() const { return counts_; }
    const FailedRequests& failed_requests() const { return failed_requests_; }
    /// Reports in DK1 format that arrived and were answered with report 17.
    std::uint64_t format_switches() const { return format_switches_; }
    const ClockMap<Dk2Time>& clock_map() const { return clock_map_; }
    const FactoryCalibration& calibration() const { return calibration_; }

  private:
    Dk2ImuSource(Transport& transport, HostTime now, const FactoryCalibration& calibration,
                 const ImuSourceConfig& config);

    Status set_up();
    void set_up_again(HostTime now);
    void take(const Packet& packet);
    KeepAliveMuxReport awake();
    void note_panel(PanelReadback panel);
    void note_exposure(LedExposure exposure);

    Transport* transport_;
    ImuSourceConfig config_;
    FactoryCalibration calibration_;
    Dk2Decoder decoder_;
    ClockMap<Dk2Time> clock_map_;
    Ring<ImuSample> ready_;
    Ring<PanelReadback> readbacks_;
    bool panel_seen_ = false;
    std::uint16_t last_frame_count_ = 0;
    Ring<LedExposure> exposures_;
    std::uint16_t last_exposure_count_ = 0;
    HostTime next_correction_{};
    bool was_gone_ = false;
    HostTime next_set_up_{};  // where it was
    std::uint16_t command_id_ = 0;
    SourceCounts counts_;
    FailedRequests failed_requests_;
    std::uint64_t format_switches_ = 0;
};

static_assert(Source<Dk2ImuSource>);

}  // namespace foverig::dk2
