#include "devices/fusion/tracked_head.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "devices/fusion/rotation.h"

namespace foverig {
namespace {

constexpr Nanoseconds kRestPeriod{20'000'000};

/// The mean of poses that are near each other.
RigidPose mean_of(std::span<const RigidPose> poses) {
    dquat sum(0, 0, 0, 0);
    dvec3 way(0);
    for (const RigidPose& pose : poses) {
        const double sign = glm::dot(pose.rotation, poses.front().rotation) < 0 ? -1.0 : 1.0;
        sum = sum + pose.rotation * sign;
        way += pose.translation_m;
    }
    return {glm::normalize(sum), way / static_cast<double>(poses.size())};
}

}  // namespace

void TrackedHead::add(const ImuSample& sample) {
    const Nanoseconds step = sample.device_time - newest_.device_time;
    inertial_.add(sample);
    const bool first = newest_.device_time == Dk2Time{};
    if (!first) {
        bias_by_warmth_rad_s_ +=
            (sample.temperature_c - newest_.temperature_c) * inertial_.bias().slope_rad_s_c();
    }
    newest_ = sample;
    if (!filter_.started() || first || step <= Nanoseconds{0}) return;
    if (step > config_.inertial.max_gap) {
        filter_.stop();  // where the head went is unknown: the next fix says
        return;
    }
    filter_.add(sample, bias_by_warmth_rad_s_);
    const double faded = std::exp(-to_seconds(step) / config_.smoothing_s);
    turn_left_rad_ *= faded;
    way_left_m_ *= faded;
    if (sample.device_time - last_fix_ < config_.alone_after) return;
    if (sample.device_time < next_rest_) return;
    next_rest_ = sample.device_time + kRestPeriod;
    const HeadFusionConfig& neck = config_.inertial;
    filter_.add_rest(-(neck.eyes_from_neck_m + neck.sensor_from_eyes_m), config_.neck_sigma_m_s);
}

void TrackedHead::add(const PoseFix& fix) {
    if (!inertial_.started()) return;
    if (filter_.started()) {
        correct(fix);
    } else if (is_beyond_inertia(fix)) {
        ++counts_.too_old;
    } else if (!world_from_camera_) {
        place_camera(fix);
    } else {
        begin(fix);
    }
}

/// HeadFusion is asked where the head was then, and knows no further back than this.
bool TrackedHead::is_beyond_inertia(const PoseFix& fix) const {
    return newest_.host_time - fix.taken > config_.inertial.max_prediction;
}

void TrackedHead::place_camera(const PoseFix& fix) {
    if (inertial_.at(fix.taken).stale) return;
    places_.push_back(sensor_by_inertia(fix.taken) * fix.camera_from_imu.inverse());
    if (static_cast<int>(places_.size()) < config_.fixes_to_place_camera) return;
    world_from_camera_ = mean_of(places_);
    begin(fix);
}

/// By HeadFusion and the neck.
RigidPose TrackedHead::sensor_by_inertia(HostTime time) const {
    const Pose head = inertial_.at(time);
    return {head.world_from_head,
            head.position_m + head.world_from_head * config_.inertial.sensor_from_eyes_m};
}

/// The fix is of a moment ago; what the head did since, gyro and neck tell.
void TrackedHead::begin(const PoseFix& fix) {
    const RigidPose before = shown();
    const RigidPose since =
        sensor_by_inertia(fix.taken).inverse() * sensor_by_inertia(newest_.host_time);
    filter_.start(newest_, *world_from_camera_ * fix.camera_from_imu * since, dvec3(0),
                  bias_by_warmth_rad_s_);
    show_as_before(before);
    unlikely_in_row_ = 0;
    last_fix_ = fix.taken_device;
}

Matrix<6, 6> TrackedHead::spread_of(const PoseFix& fix) const {
    Matrix<6, 6> to_world = Matrix<6, 6>::identity();
    to_world.set_block(3, 3, glm::mat3_cast(world_from_camera_->rotation));
    Matrix<6, 6> spread = to_world * fix.covariance * transposed(to_world);
    for (std::size_t i = 0; i < 3; ++i) {
        spread(i, i) += config_.fix_floor_rad * config_.fix_floor_rad;
        spread(i + 3, i + 3) += config_.fix_floor_m * config_.fix_floor_m;
    }
    return spread;
}

void TrackedHead::correct(const PoseFix& fix) {
    const RigidPose before = shown();
    const RigidPose world_from_imu = *world_from_camera_ * fix.camera_from_imu;
    switch (filter_.add(fix.taken_device, world_from_imu, spread_of(fix))) {
        case DelayedFilter::Verdict::taken:
            ++counts_.fixes;
            unlikely_in_row_ = 0;
            last_fix_ = fix.taken_device;
            show_as_before(before);
            break;
        case DelayedFilter::Verdict::too_old:
            ++counts_.too_old;
            break;
        case DelayedFilter::Verdict::unlikely:
            ++counts_.unlikely;
            if (++unlikely_in_row_ < config_.unlikely_until_restart) break;
            if (is_beyond_inertia(fix)) {
                ++counts_.too_old;
                break;
            }
            ++counts_.restarts;
            begin(fix);
            break;
    }
}

/// The sensor in the world as it is shown now: the filter, less what is left of corrections.
RigidPose TrackedHead::shown() const {
    if (!filter_.started()) return sensor_by_inertia(newest_.host_time);
    const RigidPose pose = filter_.now().pose();
    return {exp_map(turn_left_rad_) * pose.rotation, pose.translation_m + way_left_m_};
}

void TrackedHead::show_as_before(const RigidPose& before) {
    const RigidPose pose = filter_.now().pose();
    turn_left_rad_ = log_map(before.rotation * glm::conjugate(pose.rotation));
    way_left_m_ = before.translation_m - pose.translation_m;
}

bool TrackedHead::camera_lost() const {
    return !filter_.started() || newest_.device_time - last_fix_ > config_.stale_after;
}

dvec3 TrackedHead::gyro_bias_rad_s() const {
    return filter_.started() ? filter_.now().gyro_bias_rad_s : dvec3(0);
}

std::optional<RigidPose> TrackedHead::expected(Dk2Time time) const {
    if (!filter_.started()) return std::nullopt;
    if (const auto state = filter_.state_at(time)) {
        return world_from_camera_->inverse() * state->pose();
    }
    const double ahead_s = to_seconds(time - newest_.device_time);
    if (std::abs(ahead_s) > to_seconds(config_.inertial.max_prediction)) return std::nullopt;
    const InertialFilter::State& now = filter_.now();
    const dvec3 rate_rad_s = filter_.newest().gyro_rad_s - now.gyro_bias_rad_s;
    const RigidPose then{now.world_from_body * exp_map(rate_rad_s * ahead_s),
                         now.position_m + now.velocity_m_s * ahead_s};
    return world_from_camera_->inverse() * then;
}

Pose TrackedHead::at(HostTime time) const {
    Pose pose = inertial_.at(time);
    if (!filter_.started()) return pose;
    const InertialFilter::State& state = filter_.now();
    const RigidPose sensor = shown();
    // The turn that HeadFusion predicts from its newest sample on is as good here.
    const dquat start = inertial_.at(newest_.host_time).world_from_head;
    const dquat turn = glm::conjugate(start) * pose.world_from_head;
    pose.world_from_head = glm::normalize(sensor.rotation * turn);
    const Nanoseconds limit = config_.inertial.max_prediction;
    const double dt_s = to_seconds(std::clamp(time - newest_.host_time, -limit, limit));
    const dvec3 acceleration_m_s2 =
        state.world_from_body * (filter_.newest().accel_m_s2 - state.accel_bias_m_s2) -
        dvec3(0, kGravity_m_s2, 0);
    const dvec3 sensor_m =
        sensor.translation_m + dt_s * state.velocity_m_s + 0.5 * dt_s * dt_s * acceleration_m_s2;
    pose.position_m = sensor_m - pose.world_from_head * config_.inertial.sensor_from_eyes_m;
    return pose;
}

}  // namespace foverig
