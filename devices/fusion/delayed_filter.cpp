#include "devices/fusion/delayed_filter.h"

#include <algorithm>

namespace foverig {
namespace {

Inertial sensed_by(const ImuSample& sample, const dvec3& bias_by_warmth_rad_s) {
    return {.gyro_rad_s = sample.gyro_rad_s,
            .accel_m_s2 = sample.accel_m_s2,
            .bias_by_warmth_rad_s = bias_by_warmth_rad_s};
}

Inertial mix(const Inertial& a, const Inertial& b, double share) {
    return {
        .gyro_rad_s = glm::mix(a.gyro_rad_s, b.gyro_rad_s, share),
        .accel_m_s2 = glm::mix(a.accel_m_s2, b.accel_m_s2, share),
        .bias_by_warmth_rad_s = glm::mix(a.bias_by_warmth_rad_s, b.bias_by_warmth_rad_s, share)};
}

}  // namespace

void DelayedFilter::start(const ImuSample& sample, const RigidPose& world_from_imu,
                          const dvec3& velocity_m_s, const dvec3& bias_by_warmth_rad_s) {
    steps_.clear();
    steps_.push_back({sample.device_time, sensed_by(sample, bias_by_warmth_rad_s),
                      InertialFilter::start(world_from_imu, velocity_m_s)});
}

void DelayedFilter::add(const ImuSample& sample, const dvec3& bias_by_warmth_rad_s) {
    const Step& before = steps_.back();
    if (sample.device_time <= before.time) return;
    Step next{sample.device_time, sensed_by(sample, bias_by_warmth_rad_s), before.state};
    InertialFilter::advance(next.state, before.sensed, next.sensed,
                            to_seconds(next.time - before.time), config_.noise);
    steps_.push_back(std::move(next));
    forget(sample.device_time);
}

void DelayedFilter::add_rest(const dvec3& lever_m, double sigma_m_s) {
    InertialFilter::measure_rest(steps_.back().state, steps_.back().sensed.gyro_rad_s, lever_m,
                                 sigma_m_s);
}

void DelayedFilter::forget(Dk2Time now) {
    while (steps_.size() > 2 && now - steps_[1].time > config_.kept) steps_.pop_front();
}

std::size_t DelayedFilter::first_after(Dk2Time time) const {
    const auto after = std::upper_bound(steps_.begin(), steps_.end(), time,
                                        [](Dk2Time t, const Step& step) { return t < step.time; });
    return static_cast<std::size_t>(after - steps_.begin());
}

DelayedFilter::Step DelayedFilter::between(const Step& before, const Step& after,
                                           Dk2Time time) const {
    const double share = to_seconds(time - before.time) / to_seconds(after.time - before.time);
    Step middle{time, mix(before.sensed, after.sensed, share), before.state};
    if (time > before.time) {
        InertialFilter::advance(middle.state, before.sensed, middle.sensed,
                                to_seconds(time - before.time), config_.noise);
    }
    return middle;
}

DelayedFilter::Verdict DelayedFilter::add(Dk2Time taken, const RigidPose& world_from_imu,
                                          const Matrix<6, 6>& covariance) {
    std::size_t after = first_after(taken);
    if (after == 0 || after == steps_.size()) return Verdict::too_old;
    Step corrected = between(steps_[after - 1], steps_[after], taken);
    const double distance2 =
        InertialFilter::measure_pose(corrected.state, world_from_imu, covariance, config_.gate);
    if (!(distance2 <= config_.gate)) return Verdict::unlikely;
    steps_.insert(steps_.begin() + static_cast<std::ptrdiff_t>(after), std::move(corrected));
    for (++after; after < steps_.size(); ++after) {
        const Step& before = steps_[after - 1];
        Step& step = steps_[after];
        step.state = before.state;
        InertialFilter::advance(step.state, before.sensed, step.sensed,
                                to_seconds(step.time - before.time), config_.noise);
    }
    return Verdict::taken;
}

std::optional<InertialFilter::State> DelayedFilter::state_at(Dk2Time time) const {
    const std::size_t after = first_after(time);
    if (after == 0 || after == steps_.size()) return std::nullopt;
    return between(steps_[after - 1], steps_[after], time).state;
}

}  // namespace foverig
