#pragma once
// From the head's true motion to what the DK2's IMU reports, before its factory calibration is
// applied (DEVICES.md 6.2). With no fault named, the report is the truth in units of the report.
#include <cstdint>
#include <optional>

#include "devices/dk2/feature_reports.h"
#include "devices/dk2/input_reports.h"
#include "devices/head_geometry.h"
#include "simulators/dk2/factory_error.h"
#include "simulators/faults/faults.h"
#include "simulators/motion/head_motion.h"
#include "simulators/motion/random.h"

namespace foverig {

class ImuModel {
  public:
    /// Per sample at 1 kHz, the gyro behind its 250 Hz filter: 31 and 990 report units.
    static constexpr double kGyroNoise_deg_s = 0.177;
    static constexpr double kAccelNoise_m_s2 = 0.099;

    ImuModel(const Dk2Faults& faults, std::uint64_t seed);

    /// One sample; call once for each `index` in order, as bias walk and filter keep a state.
    /// `range` is the chip's: it says where values are clipped, and how fine they are.
    dk2::InertialSlot measure(const motion::HeadState& head, std::uint64_t index, double running_s,
                              const dk2::RangeReport& range = {});
    /// Degrees Celsius, `running_s` after power-on.
    double temperature_c(double running_s) const;
    /// What the gyro says at rest at a temperature, but for what walks.
    dvec3 gyro_at_rest_rad_s(double temperature_c) const;
    const FactoryError& factory() const { return factory_; }

  private:
    dvec3 gyro_bias_rad_s(double temperature_c) const;
    dvec3 gyro_errors(const dvec3& true_rad_s, std::uint64_t index, double running_s);
    dvec3 noise(std::uint64_t index, std::uint64_t stream, double sigma) const;

    Dk2Faults faults_;
    std::uint64_t seed_;
    FactoryError factory_;
    dmat3 gyro_scale_{1.0}, accel_scale_{1.0};
    dvec3 bias_rad_s_{0.0};
    dvec3 drift_sign_{0.0};
    dvec3 walk_rad_s_{0.0};
    std::optional<dvec3> filtered_rad_s_;
};

}  // namespace foverig
