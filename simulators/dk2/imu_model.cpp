#include "simulators/dk2/imu_model.h"

#include <cmath>
#include <numbers>

namespace foverig {
namespace {

using motion::Draws;

constexpr double kSamplePeriod_s = 1e-3;
constexpr double kCold_c = 25.0, kWarm_c = 38.0, kWarmUp_s = 480.0;
// At the ranges that the firmware starts with; steps grow with the range.
constexpr double kGyroStep_deg_s = 1.0 / 16.4, kGyroRange_deg_s = 2000.0;
constexpr double kAccelStep_g = 1.0 / 8192.0, kAccelRange_g = 4.0;

enum Stream : std::uint64_t {
    kGyroScale = 600,
    kAccelScale,
    kBias,
    kDriftSign,
    kWalk,
    kGyroNoise,
    kAccelNoise
};

dmat3 near_identity(const Draws& draws, double percent) {
    dmat3 m(1.0);
    for (int i = 0; i < 9; ++i) {
        m[i / 3][i % 3] += 0.01 * draws.uniform(static_cast<std::uint64_t>(i), -percent, percent);
    }
    return m;
}

dvec3 to_steps(const dvec3& v, double step, double range) {
    return step * glm::round(glm::clamp(v, -range, range) / step);
}

}  // namespace

ImuModel::ImuModel(const Dk2Faults& faults, std::uint64_t seed)
    : faults_(faults), seed_(seed), factory_(faults.factory, seed) {
    if (faults.scale > 0.0) {
        gyro_scale_ = near_identity(Draws(seed, kGyroScale), faults.scale);
        accel_scale_ = near_identity(Draws(seed, kAccelScale), faults.scale);
    }
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::uint64_t>(axis);
        bias_rad_s_[axis] = glm::radians(faults.bias) * Draws(seed, kBias).uniform(i, -1.0, 1.0);
        drift_sign_[axis] = Draws(seed, kDriftSign).sign(i);
    }
}

double ImuModel::temperature_c(double running_s) const {
    if (faults_.temperature_drift <= 0.0) return kCold_c;
    return kWarm_c - (kWarm_c - kCold_c) * std::exp(-running_s / kWarmUp_s);
}

dvec3 ImuModel::gyro_bias_rad_s(double temperature_c) const {
    return bias_rad_s_ +
           glm::radians(faults_.temperature_drift) * (temperature_c - kCold_c) * drift_sign_;
}

dvec3 ImuModel::gyro_at_rest_rad_s(double temperature_c) const {
    return factory_.raw_gyro(gyro_bias_rad_s(temperature_c));
}

dvec3 ImuModel::noise(std::uint64_t index, std::uint64_t stream, double sigma) const {
    const Draws draws(seed_, stream);
    return sigma *
           dvec3(draws.normal(3 * index), draws.normal(3 * index + 1), draws.normal(3 * index + 2));
}

dvec3 ImuModel::gyro_errors(const dvec3& true_rad_s, std::uint64_t index, double running_s) {
    dvec3 omega = true_rad_s;
    if (faults_.scale > 0.0) omega = gyro_scale_ * omega;
    omega += gyro_bias_rad_s(temperature_c(running_s));
    if (faults_.random_walk > 0.0) {
        walk_rad_s_ += noise(index, kWalk, faults_.random_walk * std::sqrt(kSamplePeriod_s));
        omega += walk_rad_s_;
    }
    if (faults_.low_pass > 0.0) {
        const double gain =
            -std::expm1(-2.0 * std::numbers::pi * faults_.low_pass * kSamplePeriod_s);
        filtered_rad_s_ = filtered_rad_s_ ? glm::mix(*filtered_rad_s_, omega, gain) : omega;
        omega = *filtered_rad_s_;
    }
    return omega;
}

dk2::InertialSlot ImuModel::measure(const motion::HeadState& head, std::uint64_t index,
                                    double running_s, const dk2::RangeReport& range) {
    dvec3 gyro = gyro_errors(head.angular_velocity_rad_s, index, running_s);
    dvec3 accel = motion::specific_force(head, kImuFromEyes_m, kGravity_m_s2);
    if (faults_.scale > 0.0) accel = accel_scale_ * accel;
    if (faults_.noise > 0.0) {
        gyro += noise(index, kGyroNoise, faults_.noise * glm::radians(kGyroNoise_deg_s));
        accel += noise(index, kAccelNoise, faults_.noise * kAccelNoise_m_s2);
    }
    gyro = factory_.raw_gyro(gyro);
    accel = factory_.raw_accel(accel);
    if (faults_.quantise > 0.0) {
        const double gyro_share = range.gyro_deg_s / kGyroRange_deg_s;
        const double accel_share = range.accel_g / kAccelRange_g;
        gyro = to_steps(gyro, gyro_share * glm::radians(kGyroStep_deg_s),
                        gyro_share * glm::radians(kGyroRange_deg_s));
        accel = to_steps(accel, accel_share * kGravity_m_s2 * kAccelStep_g,
                         accel_share * kGravity_m_s2 * kAccelRange_g);
    }
    return {.accel = dk2::from_si(accel), .gyro = dk2::from_si(gyro)};
}

}  // namespace foverig
