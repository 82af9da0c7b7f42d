#include "rig/report/provenance.h"

#include <fmt/format.h>

#include <vector>

namespace foverig::report {
namespace {

using nlohmann::json;

struct Called {
    const char* device;
    const char* name;
};
constexpr Called kDevices[] = {{"dk2", "headset"},
                               {"gaze", "gaze tracker"},
                               {"camera", "tracker camera"},
                               {"see_through", "see-through camera"},
                               {"panel", "panel"}};

std::string joined(const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
    return text;
}

bool is_from(const RunData& run, const char* device, const char* origin) {
    return run.text({"devices", device, "origin"}) == origin;
}

/// What moves a simulated device, in brackets behind its name.
std::string motion_of(const RunData& run, const std::string& device) {
    if (device == "dk2")
        return fmt::format(" (the head moves as {})", run.text({"scenario", "motion", "head"}));
    if (device == "gaze")
        return fmt::format(" (the eyes move as {})", run.text({"scenario", "motion", "gaze"}));
    return "";
}

/// What a recorded device was, in brackets behind its name.
std::string recorded_as(const RunData& run, const char* device) {
    const std::string was = run.text({"devices", device, "recorded_from"});
    if (was == "simulated") return " (a simulated one)";
    return was == "hardware" ? " (a real one)" : " (real or simulated: the recording does not say)";
}

/// A run that is older than its "origin" of a window calls it "hardware".
bool is_window(const RunData& run) {
    return is_from(run, "panel", "window") ||
           (is_from(run, "panel", "hardware") &&
            run.text({"scenario", "display", "kind"}) == "window");
}

std::string devices_from(const RunData& run, const std::string& origin, const char* title) {
    std::vector<std::string> names;
    for (const auto& [device, name] : kDevices) {
        if (!is_from(run, device, origin.c_str())) continue;
        if (device == std::string("panel") && is_window(run)) continue;
        names.push_back(name + (origin == "simulated"  ? motion_of(run, device)
                                : origin == "recorded" ? recorded_as(run, device)
                                                       : ""));
    }
    return names.empty() ? "" : fmt::format("{}: {}. ", title, joined(names));
}

/// Its VSyncs are the screen's or a grid of our own, its photons are a DK2 panel's.
std::string window(const RunData& run) {
    return is_window(run) ? "Shown in a window on an ordinary screen, whose light is taken to come "
                            "as a DK2 panel's would. "
                          : "";
}

/// Of simulated devices: no other has any.
std::string faults(const RunData& run) {
    const json all =
        run.summary.value(json::json_pointer("/scenario/faults"), json(json::object()));
    std::vector<std::string> named;
    for (const auto& [device, kinds] : all.items()) {
        if (!is_from(run, device.c_str(), "simulated")) continue;
        for (const auto& [kind, strength] : kinds.items())
            named.push_back(fmt::format("{}.{} = {}", device, kind, strength.dump()));
    }
    return named.empty() ? "" : fmt::format("Faults injected: {}. ", joined(named));
}

std::string worsened_gaze(const RunData& run) {
    const double ms = run.number({"scenario", "tracking", "gaze_added_latency_ms"}).value_or(0.0);
    const double deg = run.number({"scenario", "tracking", "gaze_added_noise_deg"}).value_or(0.0);
    if (ms == 0.0 && deg == 0.0) return "";
    return fmt::format("Gaze made worse on purpose: {:g} ms later, {:g} degrees of noise. ", ms,
                       deg);
}

std::string times(const RunData& run) {
    if (run.summary.value("fixed_cost", false))
        return fmt::format("Frame times are the scenario's ({}), not measured.",
                           run.text({"scenario", "cost"}));
    return run.text({"scenario", "clock"}) == "wall"
               ? "Frame times and waits are measured, in real time."
               : "Frame times are measured; waits and the devices' time are simulated (lockstep).";
}

}  // namespace

std::string provenance(const RunData& run) {
    return devices_from(run, "simulated", "Simulated") + devices_from(run, "recorded", "Recorded") +
           devices_from(run, "hardware", "Real") + window(run) + faults(run) + worsened_gaze(run) +
           times(run);
}

}  // namespace foverig::report
