#include "rig/session/simulated_world.h"

#include <cmath>

#include "rig/failure.h"
#include "rig/session/panel_settings.h"
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

}  // namespace

SimulatedWorld::SimulatedWorld(const Scenario& scenario, Clock& clock)
    : head_(motion_or_throw(
          "motion.head", scenario.motion.head,
          motion::make_head(scenario.motion.head, seed_of(scenario, SeedStream::head)))),
      eyes_(motion_or_throw(
          "motion.gaze", scenario.motion.gaze,
          motion::make_eye(scenario.motion.gaze, seed_of(scenario, SeedStream::eyes)))),
      start_(clock.now()),
      panel_(panel_settings(scenario, start_)),
      headset_(clock, *head_,
               {.faults = scenario.faults.dk2,
                .seed = seed_of(scenario, SeedStream::dk2),
                .panel = &panel_}),
      gaze_tracker_(clock, *eyes_,
                    {.faults = scenario.faults.gaze, .seed = seed_of(scenario, SeedStream::gaze)}) {
}

double SimulatedWorld::initial_yaw_rad() const {
    const dvec3 ahead = *true_head(start_) * dvec3(0.0, 0.0, -1.0);
    return std::atan2(-ahead.x, -ahead.z);
}

std::optional<dquat> SimulatedWorld::true_head(HostTime time) const {
    return head_->at(to_seconds(time.time_since_epoch())).world_from_head;
}

std::optional<std::array<dvec3, 2>> SimulatedWorld::true_gaze(HostTime time) const {
    const auto state = eyes_->at(to_seconds(time.time_since_epoch()));
    return std::array{eye_direction(Side::left, state), eye_direction(Side::right, state)};
}

}  // namespace foverig
