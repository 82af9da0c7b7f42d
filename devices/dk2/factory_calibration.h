#pragma once
// The calibration of report 3, applied on the host: corrected = M (raw - offset) (DEVICES.md 1.5).
#include "devices/dk2/calibration_reports.h"
#include "devices/math.h"

namespace foverig::dk2 {

struct FactoryCalibration {
    dvec3 accel_offset_m_s2{0};
    dvec3 gyro_offset_rad_s{0};
    dmat3 accel_from_raw{1};
    dmat3 gyro_from_raw{1};

    static FactoryCalibration from(const FactoryCalibrationReport& report);

    dvec3 accel(const Triple& raw) const {
        return accel_from_raw * (to_si(raw) - accel_offset_m_s2);
    }
    dvec3 gyro(const Triple& raw) const { return gyro_from_raw * (to_si(raw) - gyro_offset_rad_s); }
};

}  // namespace foverig::dk2
