#include "rig/session/recorded_origin.h"

#include "devices/recording/device_topics.h"
#include "rig/failure.h"
#include "rig/scenario/parse.h"
#include "rig/session/session_recording.h"

namespace foverig {
namespace {

std::optional<Origin> as_its_topic_says(const Recording& recording, std::string_view device) {
    const mcap::Channel* topic = recording.summary().channel(raw_topic(std::string(device)));
    if (topic == nullptr) return std::nullopt;
    const auto said = topic->metadata.find(kDeviceOrigin);
    if (said == topic->metadata.end()) return std::nullopt;
    for (const Origin origin : {Origin::simulated, Origin::hardware})
        if (said->second == name_of(origin)) return origin;
    return std::nullopt;
}

std::optional<Scenario> scenario_of(const Recording& recording) {
    const auto text = recording.attachment(kScenarioAttachment);
    if (!text) return std::nullopt;
    try {
        Scenario scenario;
        apply_toml(scenario, *text, recording.name());
        return scenario;
    } catch (const UsageError&) {
        return std::nullopt;  // of another version
    }
}

/// What `auto` found nobody knows, nor what a replay was of.
std::optional<Origin> as_was_asked(const Scenario& scenario, std::string_view device) {
    if (scenario.devices == "sim") return Origin::simulated;
    if (scenario.devices != "hardware") return std::nullopt;
    const std::string& asked = device == "dk2"    ? scenario.hardware.head
                               : device == "gaze" ? scenario.hardware.gaze
                                                  : scenario.hardware.camera;
    if (asked == "sim") return Origin::simulated;
    return asked == "required" ? std::optional(Origin::hardware) : std::nullopt;
}

}  // namespace

std::optional<Origin> recorded_origin(const Recording& recording, std::string_view device) {
    if (const auto said = as_its_topic_says(recording, device)) return said;
    const auto scenario = scenario_of(recording);
    return scenario ? as_was_asked(*scenario, device) : std::nullopt;
}

}  // namespace foverig
