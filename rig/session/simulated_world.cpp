#include "rig/session/simulated_world.h"

#include "rig/failure.h"
#include "simulators/gaze/tracker_geometry.h"
#include "simulators/motion/catalog.h"

namespace foverig {
namespace {

/// A wrong name is wrong usage, a recording that cannot be read wrong input.
template <class T>
std::unique_ptr<T> motion_or_throw(const char* key, const std::string& name,
                                   Result<std::unique_ptr<T>> made) {
    if (made) return std::move(made).value();
    const std::string text = std::string(key) + ": " + made.error().text;
    if (name.ends_with(".csv")) throw InputError(text);
    throw UsageError(text);
}

// One seed for all, told apart so that the head's noise is not the eyes'.
enum : std::uint64_t { kHeadStream = 1, kEyeStream, kPanelStream, kDk2Stream, kGazeStream };

std::uint64_t seed_of(const Scenario& scenario, std::uint64_t stream) {
    return (stream << 32U) | scenario.render.seed;
}

}  // namespace

SimulatedWorld::SimulatedWorld(const Scenario& scenario, Clock& clock)
    : head_(
          motion_or_throw("motion.head", scenario.motion.head,
                          motion::make_head(scenario.motion.head, seed_of(scenario, kHeadStream)))),
      eyes_(motion_or_throw("motion.gaze", scenario.motion.gaze,
                            motion::make_eye(scenario.motion.gaze, seed_of(scenario, kEyeStream)))),
      panel_({.timing = PanelTiming::at(scenario.display.rate_hz),
              .first_vsync = clock.now(),
              .faults = scenario.faults.panel,
              .seed = seed_of(scenario, kPanelStream)}),
      headset_(
          clock, *head_,
          {.faults = scenario.faults.dk2, .seed = seed_of(scenario, kDk2Stream), .panel = &panel_}),
      gaze_tracker_(clock, *eyes_,
                    {.faults = scenario.faults.gaze, .seed = seed_of(scenario, kGazeStream)}) {}

dquat SimulatedWorld::true_head(HostTime time) const {
    return head_->at(to_seconds(time.time_since_epoch())).world_from_head;
}

std::array<dvec3, 2> SimulatedWorld::true_gaze(HostTime time) const {
    const auto state = eyes_->at(to_seconds(time.time_since_epoch()));
    return {eye_direction(Side::left, state), eye_direction(Side::right, state)};
}

}  // namespace foverig
