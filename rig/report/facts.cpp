#include "rig/report/facts.h"

#include <fmt/format.h>

#include "rig/records/words.h"
#include "rig/report/markup.h"

namespace foverig::report {

namespace {

/// What a window changes in what the numbers mean; empty without one.
std::string window_note(const RunData& run) {
    const auto display = run.summary.value("display", nlohmann::json());
    if (!display.is_object()) return "";
    std::string note = fmt::format("<p>Shown on {}; VSyncs from the {}, known to within {} ms.",
                                   escaped(display.value("shown_on", "")),
                                   escaped(display.value("vsync_from", "")),
                                   number(run.number({"display", "vsync_error_ms"})));
    if (run.number({"display", "hud_frames"}).value_or(0.0) > 0.0)
        note += fmt::format(" {} frames paid for the HUD.",
                            count(run.number({"display", "hud_frames"})));
    const auto motion =
        run.summary.value(nlohmann::json::json_pointer("/scenario/motion/gaze"), std::string());
    if (motion == "mouse")
        note +=
            " The gaze tracker is simulated, without noise of its own: its eyes follow the cursor "
            "through the inverse of the lens.";
    return note + "</p>";
}

}  // namespace

std::string plan_table(const RunData& run) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& effect : run.summary.value("plan", nlohmann::json::array())) {
        std::string passes;
        for (const auto& pass : effect.value("passes", nlohmann::json::array())) {
            passes += fmt::format("<code>{}</code> ", escaped(pass.get<std::string>()));
        }
        const bool on = effect.value("on", false);
        const auto& memory = effect["bytes"];
        const auto& ms = effect["measured_ms"];
        rows.push_back({escaped(effect.value("effect", "")), on ? "<b>on</b>" : "off",
                        escaped(effect.value("because", "")), passes,
                        on && memory.is_number() ? bytes(memory.get<double>()) : "",
                        ms.is_number() ? number(ms.get<double>()) : ""});
    }
    return table({"effect", "", "because", "passes", "memory", "ms a frame"}, rows, {4, 5});
}

std::string device_table(const RunData& run) {
    std::vector<std::vector<std::string>> rows;
    const auto devices = run.summary.value("devices", nlohmann::json::object());
    for (const auto& [name, device] : devices.items()) {
        const char* key = name.c_str();
        const auto cell = [&](const char* what) {
            return count(run.number({"devices", key, what}));
        };
        rows.push_back({escaped(name), cell("samples"),
                        number(run.number({"devices", key, "rate_hz"})), cell("lost"),
                        cell("rejected"), cell("reconnects"),
                        escaped(counted(device.value("troubles", nlohmann::json::object())))});
    }
    return table({"device", "samples", "rate Hz", "lost", "rejected", "reconnects", "else"}, rows,
                 {1, 2, 3, 4, 5}) +
           window_note(run);
}

std::string resource_table(const RunData& run) {
    std::vector<std::vector<std::string>> rows;
    for (const char* kind : {"primary", "shadow", "ao", "reflection", "probe", "vpl"}) {
        const auto rays = run.number({"rays", kind});
        if (rays.value_or(0.0) > 0.0) {
            rows.push_back({fmt::format("{} rays a frame", kind), count(rays)});
        }
    }
    if (const auto cpu_ms = run.number({"cpu_time_ms", "p50"}))
        rows.push_back({"processor time a frame (p50)", number(cpu_ms) + " ms"});
    rows.push_back({"memory of the backend", bytes(run.number({"memory", "backend_bytes"}))});
    rows.push_back({"most memory of the process", bytes(run.number({"memory", "peak_rss_bytes"}))});
    rows.push_back({"NaN, infinities, clamped values in kernels",
                    fmt::format("{}, {}, {}", count(run.number({"numerics", "nan"})),
                                count(run.number({"numerics", "inf"})),
                                count(run.number({"numerics", "clamped"})))});
    return table({"", ""}, rows, {1});
}

std::string scenario_listing(const RunData& run) {
    return fmt::format("<details><summary>Scenario, resolved</summary><pre>{}</pre></details>",
                       escaped(run.summary.value("scenario", nlohmann::json::object()).dump(2)));
}

}  // namespace foverig::report
