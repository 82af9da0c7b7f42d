#pragma once
// One inertial sample, calibrated, whatever device it came from.
#include <cstdint>

#include "devices/math.h"
#include "devices/time.h"

namespace foverig {

struct ImuSample {
    HostTime host_time{};  ///< device_time through the clock map
    HostTime arrival{};    ///< when its packet was there; arrival - host_time is transport
    Dk2Time device_time{};
    std::uint64_t sequence = 0;  ///< the device's running number, unwrapped
    dvec3 accel_m_s2{0};  ///< specific force: (0, +9.8, 0) upright at rest; x right, y up, z back
    dvec3 gyro_rad_s{0};
    double temperature_c = 0;
    bool gap = false;  ///< samples before this one were lost
};

}  // namespace foverig
