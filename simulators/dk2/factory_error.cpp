#include "simulators/dk2/factory_error.h"

#include <cmath>

#include "simulators/motion/random.h"

namespace foverig {
namespace {

using motion::Draws;

// Acceptance limits of the released firmware (factory.c). It has none for the accelerometer's
// cross-axis terms: they get the gyro's.
constexpr double kCrossAxis = 0.03, kGravityOfFactory_m_s2 = 9.7859;
constexpr dvec3 kGyroScale{0.03}, kAccelScale{0.08, 0.08, 0.15};
constexpr double kZeroRate_deg_s = 10.0;
constexpr dvec3 kZeroG_m_s2 = kGravityOfFactory_m_s2 * dvec3(0.120, 0.120, 0.180);
constexpr double kCalibrated_c = 25.0;

enum Stream : std::uint64_t { kGyroRows = 620, kAccelRows, kGyroOffset, kAccelOffset };

std::array<dk2::Triple, 3> rows(const Draws& draws, const dvec3& scale, double share) {
    std::array<dk2::Triple, 3> drawn{};
    for (int row = 0; row < 3; ++row) {
        dvec3 v;
        for (int column = 0; column < 3; ++column) {
            const double most = row == column ? scale[row] : kCrossAxis;
            v[column] =
                share * draws.uniform(static_cast<std::uint64_t>(3 * row + column), -most, most);
        }
        v /= dk2::FactoryCalibrationReport::kMatrixUnit;
        drawn[static_cast<std::size_t>(row)] = {static_cast<std::int32_t>(std::lround(v.x)),
                                                static_cast<std::int32_t>(std::lround(v.y)),
                                                static_cast<std::int32_t>(std::lround(v.z))};
    }
    return drawn;
}

dvec3 offset(const Draws& draws, const dvec3& most, double share) {
    return share * most *
           dvec3(draws.uniform(0, -1.0, 1.0), draws.uniform(1, -1.0, 1.0),
                 draws.uniform(2, -1.0, 1.0));
}

dk2::FactoryCalibrationReport report_of(double share, std::uint64_t seed) {
    if (share <= 0.0) return {};
    return {.accel_offset = dk2::from_si(offset(Draws(seed, kAccelOffset), kZeroG_m_s2, share)),
            .gyro_offset = dk2::from_si(
                offset(Draws(seed, kGyroOffset), dvec3(glm::radians(kZeroRate_deg_s)), share)),
            .accel_rows = rows(Draws(seed, kAccelRows), kAccelScale, share),
            .gyro_rows = rows(Draws(seed, kGyroRows), kGyroScale, share),
            .temperature_centi_c = static_cast<std::int16_t>(100.0 * kCalibrated_c)};
}

}  // namespace

FactoryError::FactoryError(double share, std::uint64_t seed)
    : report_(report_of(share, seed)),
      calibration_(dk2::FactoryCalibration::from(report_)),
      raw_from_accel_(glm::inverse(calibration_.accel_from_raw)),
      raw_from_gyro_(glm::inverse(calibration_.gyro_from_raw)) {}

dk2::InertialSlot FactoryError::corrected(const dk2::InertialSlot& raw) const {
    return {.accel = dk2::from_si(calibration_.accel(raw.accel)),
            .gyro = dk2::from_si(calibration_.gyro(raw.gyro, kCalibrated_c))};
}

}  // namespace foverig
