#pragma once
// The gyro's raw offset by the chip's temperature, as the headset has it stored (reports 20 and
// 21), used as its own firmware does (temperature.c): the newest sample of each bin, a line between
// the two around a temperature, and the offset that it found since it was plugged in, near that
// one's temperature.
#include <optional>
#include <vector>

#include "devices/dk2/calibration_reports.h"
#include "devices/math.h"
#include "devices/transport.h"

namespace foverig::dk2 {

struct OffsetAt {
    double temperature_c = 0;
    dvec3 rad_s{0};
};

class GyroOffsets {
  public:
    GyroOffsets() = default;
    /// Nothing is known of temperature.
    explicit GyroOffsets(const dvec3& constant_rad_s) : constant_rad_s_(constant_rad_s) {}
    /// `cells` in any order, empty ones among them. What they lack `constant_rad_s` stands for.
    GyroOffsets(const dvec3& constant_rad_s, const std::vector<TemperatureReport>& cells,
                const GyroOffsetReport& since_plugged_in);

    dvec3 at(double temperature_c) const;
    /// Offsets of several temperatures are stored: the slope is known.
    bool by_temperature() const { return stored_.size() > 1; }
    const dvec3& constant_rad_s() const { return constant_rad_s_; }
    /// Of the table; empty: none is stored.
    const std::vector<OffsetAt>& stored() const { return stored_; }

  private:
    dvec3 by_table(double temperature_c) const;

    dvec3 constant_rad_s_{0};
    std::vector<OffsetAt> stored_;  // by temperature, at least kApart_c between two
    std::optional<OffsetAt> newest_;
};

/// Reads all cells of report 20, and 21. Errors: what the transport says, and invalid_data.
Result<GyroOffsets> read_gyro_offsets(Transport& transport, const dvec3& constant_rad_s);

}  // namespace foverig::dk2
