#pragma once
// The calibration of report 3, applied on the host: corrected = M (raw - offset) (DEVICES.md 1.5).
// The gyro's offset is that of the chip's temperature, where the headset has such offsets.
#include "devices/dk2/gyro_offsets.h"
#include "devices/math.h"

namespace foverig::dk2 {

struct FactoryCalibration {
    dvec3 accel_offset_m_s2{0};
    GyroOffsets gyro_offsets;
    dmat3 accel_from_raw{1};
    dmat3 gyro_from_raw{1};

    /// Of report 3 alone: one offset for all temperatures.
    static FactoryCalibration from(const FactoryCalibrationReport& report);

    dvec3 accel(const Triple& raw) const {
        return accel_from_raw * (to_si(raw) - accel_offset_m_s2);
    }
    dvec3 gyro(const Triple& raw, double temperature_c) const {
        return gyro_from_raw * (to_si(raw) - gyro_offsets.at(temperature_c));
    }
};

}  // namespace foverig::dk2
