#pragma once
// The DK2's feature reports as its firmware keeps them (DEVICES.md 1.5, 1.6).
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "devices/dk2/calibration_reports.h"
#include "devices/dk2/feature_reports.h"
#include "devices/dk2/input_reports.h"
#include "devices/result.h"
#include "devices/time.h"

namespace foverig {

class FeatureBank {
  public:
    /// The gyro's offset at a temperature in degrees Celsius, as earlier hosts stored it.
    using StoredOffset = std::function<dvec3(double)>;

    /// A device that was plugged in at `now`, with the firmware's defaults. Without `stored` its
    /// temperature table is empty.
    FeatureBank(HostTime now, const dk2::FactoryCalibrationReport& factory,
                StoredOffset stored = {})
        : factory_(factory), stored_offset_(std::move(stored)), last_set_(now) {}

    /// `report` is the whole report, id included. What the firmware would write to its memory for
    /// good (calibrations, positions, serials) is refused, and so is the way into its boot loader.
    Status set(Bytes report, HostTime now);
    /// Steps to the next index where the firmware does (reports 15, 16, 18 and 20). All carry the
    /// last SET's CommandID. Report 7 and what is no report are refused, which is a stall on USB.
    Result<std::vector<std::byte>> get(std::uint8_t id);

    /// Input reports flow and LEDs light; false after a time-out without any SET.
    bool alive(HostTime now) const;
    std::uint16_t last_command_id() const { return last_command_id_; }
    std::uint8_t input_report() const { return input_report_; }
    const dk2::ConfigReport& config() const { return config_; }
    const dk2::RangeReport& range() const { return range_; }
    const dk2::DisplayReport& display() const { return display_; }
    const dk2::TrackingReport& tracking() const { return tracking_; }
    /// When the last SET of the tracking report came.
    HostTime tracking_since() const { return tracking_since_; }

  private:
    Result<std::vector<std::byte>> answer(std::uint8_t id);
    dk2::TemperatureReport temperature_cell(std::size_t cell) const;

    dk2::FactoryCalibrationReport factory_;
    StoredOffset stored_offset_;
    HostTime last_set_;
    std::uint16_t last_command_id_ = 0;
    std::uint8_t input_report_ = 11;
    dk2::ConfigReport config_;
    dk2::RangeReport range_;
    dk2::RegisterReport register_;
    dk2::TrackingReport tracking_;
    dk2::DisplayReport display_;
    dk2::KeepAliveMuxReport keep_alive_;
    HostTime tracking_since_{};
    std::size_t next_position_ = 0, next_pattern_ = 0, next_stage_ = 0, next_cell_ = 0;
};

}  // namespace foverig
