#include "devices/gaze/gaze_filter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foverig {
namespace {

constexpr double kDegreesPerRadian = 180 / std::numbers::pi;

double angle_deg(const dvec3& a, const dvec3& b) {
    return kDegreesPerRadian * std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace

void GazeFilter::add(const GazeSample& sample) {
    if (last_ && sample.host_time <= *last_) return;
    last_ = sample.host_time;
    const auto usable = [&](const GazeEye& eye) {
        return eye.ray.valid && !eye.blink && eye.confidence >= config_.min_confidence;
    };
    const bool left = usable(sample.left), right = usable(sample.right);
    const GazeRay nothing;
    // A combined ray made of two doubtful eyes is doubtful.
    const GazeRay& combined = left || right ? sample.combined : nothing;
    add(combined_, sample.host_time, combined);
    add(left_, sample.host_time, left ? sample.left.ray : combined);
    add(right_, sample.host_time, right ? sample.right.ray : combined);
}

void GazeFilter::add(Track& track, HostTime time, const GazeRay& ray) {
    track.held = !ray.valid;
    if (track.held) {
        // What comes after a blink starts fresh: the eye has moved under the lid.
        track.recent.fill(std::nullopt);
        track.saccade = false;
        return;
    }
    const Seen* base = nullptr;
    for (const auto& seen : track.recent) {
        if (!seen) break;
        base = &*seen;
        if (time - seen->time >= config_.velocity_baseline) break;
    }
    const double speed_deg_s =
        base ? angle_deg(base->direction, ray.direction) / to_seconds(time - base->time) : 0;
    const bool fresh = base == nullptr;
    const bool was_saccade = track.saccade;
    track.saccade = speed_deg_s > config_.saccade_deg_s;

    dvec3 direction = ray.direction;
    const bool smooth =
        !fresh && !track.saccade && !was_saccade && config_.fixation_time_constant_s > 0;
    if (smooth) {
        const double dt_s = to_seconds(time - track.recent[0]->time);
        const double weight = -std::expm1(-dt_s / config_.fixation_time_constant_s);
        direction = glm::normalize(glm::mix(track.filtered->direction, ray.direction, weight));
    }
    track.filtered = Seen{time, direction};
    std::shift_right(track.recent.begin(), track.recent.end(), 1);
    track.recent[0] = Seen{time, ray.direction};
}

FilteredEye GazeFilter::at(const Track& track, HostTime photon) const {
    FilteredEye eye;
    if (!track.filtered) return eye;
    eye.direction = track.filtered->direction;
    eye.age = photon - track.filtered->time;
    eye.held = track.held;
    eye.saccade = track.saccade;
    eye.usable = eye.age <= config_.hold_limit;
    return eye;
}

FilteredGaze GazeFilter::at(HostTime photon) const {
    return {at(left_, photon), at(right_, photon), at(combined_, photon)};
}

}  // namespace foverig
