#include "rig/session/simulated_world.h"

#include <cmath>

#include "rig/failure.h"
#include "rig/session/live_parts.h"
#include "rig/session/panel_settings.h"
#include "rig/session/see_through_camera.h"
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

/// Null where a cursor moves the eyes.
std::unique_ptr<motion::EyeMotion> eyes_or_throw(const Scenario& scenario, bool pointed) {
    const std::string& name = scenario.motion.gaze;
    if (name == kMouseGaze) {
        if (pointed) return nullptr;
        throw UsageError(
            "motion.gaze = mouse: the eyes follow the cursor of a window, and there is none; add "
            "--display window");
    }
    return motion_or_throw("motion.gaze", name,
                           motion::make_eye(name, seed_of(scenario, SeedStream::eyes)));
}

}  // namespace

SimulatedWorld::SimulatedWorld(const Scenario& scenario, Clock& clock,
                               const motion::EyeMotion* pointed_eyes)
    : clock_(clock),
      see_through_settings_(scenario.see_through),
      head_(motion_or_throw(
          "motion.head", scenario.motion.head,
          motion::make_head(scenario.motion.head, seed_of(scenario, SeedStream::head)))),
      eyes_(eyes_or_throw(scenario, pointed_eyes != nullptr)),
      pointed_eyes_(eyes_ ? nullptr : pointed_eyes),
      start_(clock.now()),
      panel_(panel_settings(scenario, start_)),
      headset_(clock, *head_,
               {.faults = scenario.faults.dk2,
                .seed = seed_of(scenario, SeedStream::dk2),
                .panel = &panel_}),
      gaze_tracker_(clock, eyes_ ? *eyes_ : *pointed_eyes_,
                    {.faults = scenario.faults.gaze, .seed = seed_of(scenario, SeedStream::gaze)}) {
    if (!scenario.tracking.camera) return;
    auto leds = dk2::read_leds(headset_);
    if (!leds) throw DeviceError("tracking.camera: " + leds.error().text);
    camera_.emplace(clock, *head_, headset_,
                    SimulatedCamera::Settings{.leds = std::move(leds).value(),
                                              .faults = scenario.faults.camera,
                                              .seed = seed_of(scenario, SeedStream::camera)});
}

Transport* SimulatedWorld::see_through_camera() {
    if (!see_through_)
        see_through_ = open_see_through_camera(see_through_settings_, clock_,
                                               [this](HostTime t) { return *true_head(t); });
    return see_through_.get();
}

Origin SimulatedWorld::origin(std::string_view device) const {
    const bool real = device == "see_through" && see_through_settings_.camera != "sim";
    return real ? Origin::hardware : Origin::simulated;
}

double SimulatedWorld::initial_yaw_rad() const {
    const dvec3 ahead = *true_head(start_) * dvec3(0.0, 0.0, -1.0);
    return std::atan2(-ahead.x, -ahead.z);
}

std::optional<dquat> SimulatedWorld::true_head(HostTime time) const {
    return head_->at(to_seconds(time.time_since_epoch())).world_from_head;
}

std::optional<std::array<dvec3, 2>> SimulatedWorld::true_gaze(HostTime time) const {
    if (!eyes_) return std::nullopt;  // nobody knows where a hand will move the cursor
    const auto state = eyes_->at(to_seconds(time.time_since_epoch()));
    return std::array{eye_direction(Side::left, state), eye_direction(Side::right, state)};
}

}  // namespace foverig
