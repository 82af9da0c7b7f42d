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
    : recording_(opened(replayed_file(scenario))),
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
    if (!recording_.has("camera")) {
        throw InputError(
            fmt::format("{}: holds no frames of a tracker camera; expected tracking.camera = false",
                        recording_.name()));
    }
    camera_.emplace(recording_, "camera", clock,
                    ReplayedDevice::Settings{.loop = scenario.replay.loop,
                                             .successive_requests = camera::request_selectors()});
}

bool ReplayedWorld::at_end() const {
    for (const ReplayedDevice* device : {&headset_, &gaze_tracker_}) {
        if (device->damage()) throw InputError(device->damage()->text);
    }
    if (camera_ && camera_->damage()) throw InputError(camera_->damage()->text);
    return headset_.at_end() && gaze_tracker_.at_end() && (!camera_ || camera_->at_end());
}

}  // namespace foverig
