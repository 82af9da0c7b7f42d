#include "rig/records/motion_phase.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <numbers>

#include "rig/records/columns.h"
#include "rig/records/distribution.h"

namespace foverig {
namespace {

using nlohmann::json;
using Value = std::function<std::optional<double>(const FrameRecord&)>;

constexpr double kDegrees = 180.0 / std::numbers::pi;

/// None for the first of two, or where two were meant for one instant.
std::optional<double> seconds_between(const FrameRecord& before, const FrameRecord& frame) {
    const double seconds = to_seconds(frame.predicted_photon - before.predicted_photon);
    return seconds > 0.0 ? std::optional(seconds) : std::nullopt;
}

double angle_deg(const dvec3& a, const dvec3& b) {
    return kDegrees * std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

bool head_moves(const FrameRecord* before, const FrameRecord& frame) {
    if (frame.true_head_speed_deg_s) return *frame.true_head_speed_deg_s >= kHeadMoves_deg_s;
    if (before == nullptr) return false;
    const auto seconds = seconds_between(*before, frame);
    const dquat turn = glm::conjugate(before->world_from_head) * frame.world_from_head;
    const double turned_deg =
        kDegrees * 2.0 * std::atan2(glm::length(dvec3(turn.x, turn.y, turn.z)), std::abs(turn.w));
    return seconds && turned_deg / *seconds >= kHeadMoves_deg_s;
}

bool eyes_move(const FrameRecord* before, const FrameRecord& frame) {
    const bool known = before != nullptr && before->best_known_gaze[0] && frame.best_known_gaze[0];
    if (!known) return frame.saccade;
    const auto seconds = seconds_between(*before, frame);
    return seconds && angle_deg(dvec3(*before->best_known_gaze[0]),
                                dvec3(*frame.best_known_gaze[0])) >= kEyesMove_deg_s * *seconds;
}

/// What a frame is, given whether it moves and how long ago a movement began (none: never).
using Rule = Phase (*)(bool moves, std::optional<double> since_ms);

std::vector<Phase> phases(const std::vector<FrameRecord>& frames,
                          bool (*moves)(const FrameRecord*, const FrameRecord&), Rule rule) {
    std::vector<Phase> all;
    std::optional<HostTime> began;
    bool moved = true;  // what moves at the start began nobody knows when
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const bool now = moves(i == 0 ? nullptr : &frames[i - 1], frames[i]);
        if (now && !moved) began = frames[i].predicted_photon;
        moved = now;
        all.push_back(rule(
            now, began ? std::optional(to_ms(frames[i].predicted_photon - *began)) : std::nullopt));
    }
    return all;
}

/// Null where no frame of that phase has the value.
json spread(const std::vector<FrameRecord>& frames, const std::vector<Phase>& phase_of, Phase phase,
            const Value& value) {
    std::vector<double> values;
    for (std::size_t i = 0; i < frames.size(); ++i)
        if (const auto v = value(frames[i]); phase_of[i] == phase && v) values.push_back(*v);
    return to_json(distribution_of(std::move(values)));
}

json phase_json(const std::vector<FrameRecord>& frames, const std::vector<Phase>& phase_of,
                Phase phase, const std::vector<std::pair<const char*, Value>>& values) {
    json of_phase = {{"frames", std::count(phase_of.begin(), phase_of.end(), phase)}};
    for (const auto& [name, value] : values)
        of_phase[name] = spread(frames, phase_of, phase, value);
    return of_phase;
}

}  // namespace

std::vector<Phase> head_phases(const std::vector<FrameRecord>& frames) {
    return phases(frames, head_moves, [](bool moves, std::optional<double> since_ms) {
        if (!moves) return Phase::rest;
        return since_ms && *since_ms <= kOnset_ms ? Phase::onset : Phase::steady;
    });
}

std::vector<Phase> gaze_phases(const std::vector<FrameRecord>& frames) {
    return phases(frames, eyes_move, [](bool, std::optional<double> since_ms) {
        return since_ms && *since_ms <= kOnset_ms ? Phase::onset : Phase::steady;
    });
}

json latency_by_phase_json(const std::vector<FrameRecord>& frames) {
    const auto head = head_phases(frames);
    const auto gaze = gaze_phases(frames);
    using F = const FrameRecord&;
    const std::vector<std::pair<const char*, Value>> of_head{
        {"motion_to_photon", motion_to_photon_ms},
        {"head_lag", [](F f) { return f.head_lag_ms; }},
        {"prediction_error_deg", [](F f) { return f.prediction_error_deg; }}};
    const std::vector<std::pair<const char*, Value>> of_gaze{
        {"gaze_to_photon", gaze_to_photon_ms},
        {"gaze_error_deg", [](F f) { return f.gaze_error_deg; }}};
    return {{"onset_ms", kOnset_ms},
            {"head_moves_deg_s", kHeadMoves_deg_s},
            {"eyes_move_deg_s", kEyesMove_deg_s},
            {"head",
             {{"onset", phase_json(frames, head, Phase::onset, of_head)},
              {"steady", phase_json(frames, head, Phase::steady, of_head)},
              {"rest", phase_json(frames, head, Phase::rest, of_head)}}},
            {"gaze",
             {{"onset", phase_json(frames, gaze, Phase::onset, of_gaze)},
              {"steady", phase_json(frames, gaze, Phase::steady, of_gaze)}}}};
}

}  // namespace foverig
