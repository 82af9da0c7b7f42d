#pragma once
// Input reports -> samples in the device's time. No transport, no host time.
#include <cstdint>
#include <vector>

#include "devices/dk2/factory_calibration.h"
#include "devices/dk2/input_reports.h"
#include "devices/dk2/stamp_unwrapper.h"
#include "devices/imu_sample.h"

namespace foverig::dk2 {

/// The panel's part of a report 11: the newest vsync and the grey read back (DEVICES.md 1.7).
struct PanelReadback {
    std::uint16_t frame_count = 0;
    Dk2Time vsync_device{};
    HostTime vsync{};  ///< set by Dk2ImuSource
    std::uint8_t grey = 0;
};

/// The LEDs' newest flash, which is the camera's exposure (DEVICES.md 1.8.3).
struct LedExposure {
    std::uint16_t count = 0;  ///< since the LEDs were enabled; 0: there was none yet
    std::uint8_t pattern = 0;
    Dk2Time start_device{};
    HostTime start{};  ///< set by Dk2ImuSource
};

struct DecodedReport {
    std::vector<ImuSample> samples;  ///< oldest first; host_time and arrival not yet set
    PanelReadback panel;             ///< only of report 11
    LedExposure exposure;            ///< only of report 11
    std::uint16_t last_command_id = 0;
    std::uint16_t lost = 0;   ///< samples missing before this report
    bool is_report1 = false;  ///< DK1 format: times continued by count
    bool restarted = false;   ///< the device's clock began anew
};

class Dk2Decoder {
  public:
    explicit Dk2Decoder(const FactoryCalibration& calibration = {}) : calibration_(calibration) {}

    /// invalid_data for malformed, duplicate and backwards reports, and for a report 1 with no
    /// report 11 before it to take its time from.
    Result<DecodedReport> decode(Bytes packet);

    /// Its memory serves the next one, so that a stream of reports allocates nothing.
    void take_back(DecodedReport&& report) { spare_ = std::move(report.samples); }

    /// The device was gone: the next report begins anew, as after a restart.
    void expect_restart() {
        stamps_.expect_restart();
        counting_ = false;
    }

    /// Reports refused because their stamp, or a report 1's count, ran backwards or stood.
    std::uint64_t backwards() const { return backwards_; }
    std::uint64_t duplicates() const { return duplicates_; }

  private:
    Result<DecodedReport> decode11(Bytes packet);
    Result<DecodedReport> decode1(Bytes packet);
    std::uint16_t missing_before(std::uint16_t sample_count) const;
    std::uint16_t count(std::uint16_t sample_count, std::uint8_t num_samples);
    void expand(DecodedReport& out, std::span<const InertialSlot> slots, int num_samples,
                std::int16_t temperature_centi_c, Dk2Time newest);

    FactoryCalibration calibration_;
    StampUnwrapper stamps_;
    bool counting_ = false;
    std::uint64_t next_sequence_ = 0;  // expected number of the next sample, unwrapped
    Dk2Time newest_{};
    std::vector<ImuSample> spare_;
    std::uint64_t backwards_ = 0, duplicates_ = 0;
};

}  // namespace foverig::dk2
