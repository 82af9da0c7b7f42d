#include "rig/session/replayed_world.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "devices/camera/esp570.h"
#include "devices/dk2/led_reports.h"
#include "devices/gaze/requests.h"
#include "rig/failure.h"
#include "rig/session/panel_settings.h"
#include "rig/session/session_recording.h"

namespace foverig {
namespace {

Recording opened(const std::string& file) {
    auto recording = Recording::open(file);
    if (!recording) throw InputError(recording.error().text);
    for (const char* device : {"dk2", "gaze"}) {
        if (!recording->has(device)) {
            throw InputError(
                fmt::format("{}: holds no packets of {}; expected a recording that foverig made",
                            file, device));
        }
    }
    return std::move(recording).value();
}

/// Recordings of devices whose start nobody knew say nothing of it.
double yaw_of(const Recording& recording) {
    const auto session = recording.metadata(kSessionNote);
    if (!session || !session->contains(kInitialYaw)) return 0.0;
    const std::string& text = session->at(kInitialYaw);
    double yaw_rad = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), yaw_rad);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(yaw_rad)) {
        throw InputError(fmt::format("{}: {} of {} is \"{}\"; expected a number", recording.name(),
                                     kInitialYaw, kSessionNote, text));
    }
    return yaw_rad;
}

}  // namespace

ReplayedWorld::ReplayedWorld(const Scenario& scenario, Clock& clock)
    : clock_(clock),
      sees_through_(!scenario.see_through.camera.empty()),
      loop_(scenario.replay.loop),
      recording_(opened(replayed_file(scenario))),
      initial_yaw_rad_(yaw_of(recording_)),
      recorded_gaze_(recording_, clock.now(), scenario.replay.loop),
      panel_(panel_settings(scenario, clock.now())),
      headset_(recording_, "dk2", clock,
               {.loop = scenario.replay.loop,
                .successive_requests = {dk2::PositionReport::kId, dk2::PatternReport::kId,
                                        dk2::TemperatureReport::kId}}),
      gaze_tracker_(recording_, "gaze", clock,
                    {.loop = scenario.replay.loop, .momentary_request = gaze::request::get_time}) {
    if (!scenario.tracking.camera) return;
    require("camera", "a tracker camera", "tracking.camera = false");
    camera_.emplace(recording_, "camera", clock,
                    ReplayedDevice::Settings{.loop = scenario.replay.loop,
                                             .successive_requests = camera::request_selectors()});
}

void ReplayedWorld::require(const char* device, const char* what, const char* expected) const {
    if (recording_.has(device)) return;
    throw InputError(
        fmt::format("{}: holds no frames of {}; expected {}", recording_.name(), what, expected));
}

Transport* ReplayedWorld::see_through_camera() {
    if (!sees_through_) return nullptr;
    if (!see_through_) {
        require("see_through", "a see-through camera", "see_through.camera = \"\"");
        see_through_.emplace(recording_, "see_through", clock_,
                             ReplayedDevice::Settings{.loop = loop_});
    }
    return &*see_through_;
}

bool ReplayedWorld::at_end() const {
    bool all = true;
    for (const ReplayedDevice* device : {&headset_, &gaze_tracker_, camera_ ? &*camera_ : nullptr,
                                         see_through_ ? &*see_through_ : nullptr}) {
        if (device == nullptr) continue;
        if (device->damage()) throw InputError(device->damage()->text);
        all = all && device->at_end();
    }
    return all;
}

}  // namespace foverig
