#pragma once
// What the DK2's chips are off by as they come from their maker, and the calibration with which the
// factory answers it (DEVICES.md 1.5, report 3).
#include <cstdint>

#include "devices/dk2/calibration_reports.h"
#include "devices/dk2/factory_calibration.h"
#include "devices/dk2/input_reports.h"

namespace foverig {

class FactoryError {
  public:
    /// Drawn up to `share` of what the factory accepts; 0: the chips are right.
    FactoryError(double share, std::uint64_t seed);

    const dk2::FactoryCalibrationReport& report() const { return report_; }
    /// What a chip says where the right value is this, in SI units.
    dvec3 raw_accel(const dvec3& m_s2) const {
        return raw_from_accel_ * m_s2 + calibration_.accel_offset_m_s2;
    }
    dvec3 raw_gyro(const dvec3& rad_s) const {
        return raw_from_gyro_ * rad_s + dk2::to_si(report_.gyro_offset);
    }
    /// As the firmware corrects a sample, where its host wants that.
    dk2::InertialSlot corrected(const dk2::InertialSlot& raw) const;

  private:
    dk2::FactoryCalibrationReport report_;
    dk2::FactoryCalibration calibration_;
    dmat3 raw_from_accel_, raw_from_gyro_;
};

}  // namespace foverig
