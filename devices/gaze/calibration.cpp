#include "devices/gaze/calibration.h"

#include <fmt/format.h>

#include <utility>

#include "devices/gaze/calibration_targets.h"
#include "devices/gaze/requests.h"

namespace foverig::gaze {
namespace {

std::vector<std::byte> encoded(const std::vector<CalibrationProcedure::Target>& targets) {
    std::vector<Vec2f> por_px;
    for (const auto& target : targets) por_px.push_back(por_of(target.at_deg));
    return encode_targets(por_px);
}

bool well_seen(const GazeEye& eye) {
    return eye.ray.valid && eye.state == EyeState::tracked;
}

}  // namespace

const char* text_of(CalibrationReason reason) {
    switch (reason) {
        case CalibrationReason::none:
            return "no reason given";
        case CalibrationReason::no_eyes:
            return "the eyes were not seen long enough";
        case CalibrationReason::unstable:
            return "the gaze was not steady";
        case CalibrationReason::timed_out:
            return "nobody accepted the point in time";
        case CalibrationReason::host_abort:
            return "the host ended it";
    }
    return "a reason that SGZ1 does not know";
}

CalibrationProcedure::CalibrationProcedure(Task task, const std::vector<dvec2>& targets_deg,
                                           HostTime now, const CalibrationConfig& config)
    : task_(task), config_(config), since_(now), watch_(config.fixation) {
    for (const dvec2& at_deg : targets_deg) targets_.push_back({.at_deg = at_deg});
}

std::optional<std::size_t> CalibrationProcedure::shown() const {
    const bool shows =
        step_ == Step::settling || step_ == Step::accepting || step_ == Step::collecting;
    return shows ? std::optional(at_) : std::nullopt;
}

std::optional<CalibrationProcedure::Order> CalibrationProcedure::next_order(HostTime now) {
    if (std::exchange(owes_abort_, false)) return Order{.request = request::cal_abort};
    switch (step_) {
        case Step::starting:
            await(now);
            return Order{
                .request = task_ == Task::calibrate ? request::cal_start : request::validate,
                .value = static_cast<std::uint16_t>(targets_.size()),
                .data = encoded(targets_)};
        case Step::awaiting:
        case Step::accepting:
        case Step::collecting:
            if (now - since_ <= config_.longest_silence) return std::nullopt;
            give_up("the tracker does not answer");
            return next_order(now);
        case Step::settling:
            return order_of_settling(now);
        case Step::over:
            return std::nullopt;
    }
    return std::nullopt;
}

std::optional<CalibrationProcedure::Order> CalibrationProcedure::order_of_settling(HostTime now) {
    if (now - since_ > config_.longest_look) {
        give_up(fmt::format("the eyes did not rest on target {} of {} within {:.0f} s", at_ + 1,
                            targets_.size(), to_seconds(config_.longest_look)));
        return next_order(now);
    }
    if (now - since_ < config_.shortest_look || !watch_.rests()) return std::nullopt;
    step_ = Step::accepting;
    since_ = now;
    return Order{.request = request::cal_accept};
}

void CalibrationProcedure::await(HostTime now) {
    step_ = Step::awaiting;
    since_ = now;
}

void CalibrationProcedure::show(std::size_t target, HostTime now) {
    if (target >= targets_.size())
        return give_up(
            fmt::format("the tracker asks for target {} of {}", target + 1, targets_.size()));
    at_ = target;
    step_ = Step::settling;
    since_ = now;
    watch_.lost();
}

void CalibrationProcedure::take(const CalibrationFrame& frame, HostTime now) {
    if (state_ != State::running) return;
    switch (frame.state) {
        case CalibrationState::idle:
            return;
        case CalibrationState::waiting:
            return show(frame.current_point, now);
        case CalibrationState::collecting:
            if (targets_.empty()) return;
            step_ = Step::collecting;
            since_ = now;
            meters_ = {};
            collected_from_ =
                GazeTime(Nanoseconds(static_cast<std::int64_t>(frame.header.queued_ns)));
            ++targets_[at_].attempts;
            return;
        case CalibrationState::point_accepted:
            return await(now);
        case CalibrationState::point_rejected:
            return point_refused(frame.reason, now);
        case CalibrationState::done:
            return point_done(frame, now);
        case CalibrationState::failed:
            return fail(fmt::format("the tracker gave up: {}", text_of(frame.reason)));
        case CalibrationState::aborted:
            state_ = State::aborted;
            step_ = Step::over;
            return;
    }
}

void CalibrationProcedure::point_refused(CalibrationReason reason, HostTime now) {
    await(now);
    if (targets_.empty() || targets_[at_].attempts < config_.attempts) return;
    give_up(fmt::format("target {} of {} was refused {} times: {}", at_ + 1, targets_.size(),
                        targets_[at_].attempts, text_of(reason)));
}

/// A validation says so of each target, a calibration once.
void CalibrationProcedure::point_done(const CalibrationFrame& frame, HostTime now) {
    outcome_ = frame;
    if (task_ == Task::validate && !targets_.empty()) {
        Target& target = targets_[at_];
        keep_quality(target);
        target.told_accuracy_deg = frame.accuracy_deg;
        target.told_rms_s2s_deg = frame.precision_deg;
        if (at_ + 1 < targets_.size()) return await(now);
    }
    state_ = State::done;
    step_ = Step::over;
}

void CalibrationProcedure::take(const GazeSample& sample) {
    if (step_ == Step::settling) {
        if (sample.combined.valid)
            watch_.add(sample.device_time, sample.combined.direction);
        else
            watch_.lost();
    }
    if (step_ == Step::collecting && sample.device_time > collected_from_) measure(sample);
}

void CalibrationProcedure::measure(const GazeSample& sample) {
    if (!well_seen(sample.left) || !well_seen(sample.right) || !sample.combined.valid) {
        for (DataQualityMeter* meter : {&meters_.left, &meters_.right, &meters_.combined})
            meter->gap();
        return;
    }
    meters_.left.add(sample.left.ray.direction);
    meters_.right.add(sample.right.ray.direction);
    meters_.combined.add(sample.combined.direction);
    meters_.left_base_m = sample.left.ray.base_point_m;
    meters_.right_base_m = sample.right.ray.base_point_m;
    meters_.combined_base_m = sample.combined.base_point_m;
}

/// Each eye sees the target from where it is.
void CalibrationProcedure::keep_quality(Target& target) const {
    const dvec3 ahead = gaze_direction(target.at_deg);
    const dvec3 place_m = meters_.combined_base_m + config_.mapping_m * ahead;
    target.left = meters_.left.against(place_m - meters_.left_base_m);
    target.right = meters_.right.against(place_m - meters_.right_base_m);
    target.combined = meters_.combined.against(ahead);
}

void CalibrationProcedure::fail(const std::string& why) {
    if (state_ != State::running) return;
    state_ = State::failed;
    step_ = Step::over;
    failure_ = why;
}

/// The tracker does not know yet that it is over.
void CalibrationProcedure::give_up(const std::string& why) {
    if (state_ != State::running) return;
    owes_abort_ = true;
    fail(why);
}

void CalibrationProcedure::abort() {
    if (state_ != State::running) return;
    owes_abort_ = step_ != Step::starting;
    state_ = State::aborted;
    step_ = Step::over;
}

}  // namespace foverig::gaze
