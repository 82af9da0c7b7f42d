#include "rig/summary_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "rig/records/elsewhere.h"
#include "rig/records/words.h"

namespace foverig {
namespace {

using nlohmann::json;

std::string number(const json& value, const char* unit = "") {
    return value.is_number() ? fmt::format("{:.4g}{}", value.get<double>(), unit) : "-";
}

std::string megabytes(const json& bytes) {
    if (!bytes.is_number()) return "-";
    const double count = bytes.get<double>();
    return count == 0.0 ? "none of its own" : fmt::format("{:.3g} MB", count * 1e-6);
}

std::string percentile(const json& p) {
    if (p["value"].is_number()) {
        return fmt::format("{} [{}, {}]", number(p["value"]), number(p["ci95"][0]),
                           number(p["ci95"][1], " ms"));
    }
    return fmt::format("n too small ({} independent frames of {})", number(p["effective_n"]),
                       number(p["needed_n"]));
}

/// Beyond the warm-up, with 95 % intervals.
std::string steady(const json& s) {
    std::string text = fmt::format("p50 {}  p99 {}", percentile(s["p50"]), percentile(s["p99"]));
    if (const auto cold = s["warm_up_frames"].get<std::size_t>(); cold > 0)
        text += fmt::format("; without the first {}, which are warm-up", cold);
    return text;
}

std::string spread(const json& d, const char* unit) {
    if (!d.is_object()) return "not measured";
    return fmt::format("p50 {}  p99 {}  max {}", number(d["p50"], unit), number(d["p99"], unit),
                       number(d["max"], unit));
}

/// What did not come as it was sent, of each device that has any.
std::string losses(const json& devices) {
    std::string text;
    for (const auto& [name, device] : devices.items()) {
        json counts = device.value("troubles", json::object());
        for (const char* key : {"lost", "rejected"}) counts[key] = device.value(key, json());
        if (const std::string what = counted(counts); !what.empty())
            text += fmt::format("losses            {}: {}\n", name, what);
    }
    return text;
}

/// When each device was not there; the first three times of each.
std::string outages(const json& devices) {
    constexpr std::size_t kShown = 3;
    std::string text;
    for (const auto& [name, device] : devices.items()) {
        const json all = device.value("outages", json());
        if (!all.is_array() || all.empty()) continue;
        std::string times;
        for (std::size_t i = 0; i < std::min(all.size(), kShown); ++i) {
            const json &lost = all[i]["lost_s"], &back = all[i]["back_s"];
            times += fmt::format(
                "{}at {:.2f} s {}", i == 0 ? "" : ", ", lost.get<double>(),
                back.is_number()
                    ? fmt::format("for {:.2f} s", back.get<double>() - lost.get<double>())
                    : "for good");
        }
        if (all.size() > kShown) times += fmt::format(" and {} times more", all.size() - kShown);
        text +=
            fmt::format("lost              {}: {}; its last sample stood meanwhile\n", name, times);
    }
    return text;
}

}  // namespace

std::string summary_text(const json& s) {
    const json& frames = s["frames"];
    const json& vsync = s["vsync"];
    const json& latency = s["latency_ms"];
    std::string text;
    text += fmt::format("frames            {} rendered, {} shown, {} dropped{}\n",
                        number(frames["rendered"]), number(frames["presented"]),
                        number(frames["dropped"]),
                        s["interrupted"].get<bool>() ? " (ended early)" : "");
    text += fmt::format("frame time        {}\n", spread(s["frame_time_ms"], " ms"));
    if (const json& times = s.value("steady_frame_time_ms", json()); times.is_object())
        text += fmt::format("steady            {}\n", steady(times));
    if (const std::string elsewhere = elsewhere_text(s); !elsewhere.empty())
        text += fmt::format("not alone         elsewhere went {}\n", elsewhere);
    text += fmt::format("vsync             {} of {} missed at {}, budget {}\n",
                        number(vsync["missed"]), number(vsync["total"]),
                        number(vsync["rate_hz"], " Hz"), number(vsync["budget_ms"], " ms"));
    text += fmt::format("motion to photon  {}\n", spread(latency["motion_to_photon"], " ms"));
    text += fmt::format("gaze to photon    {}\n", spread(latency["gaze_to_photon"], " ms"));
    const json tracking = s.value("tracking", json::object());
    const auto stale_pose = tracking.value("pose_stale_frames", 0U);
    const auto stale_gaze = tracking.value("gaze_stale_frames", 0U);
    if (stale_pose + stale_gaze > 0)
        text += fmt::format(
            "tracking lost     head pose stale in {} frames, gaze in {}: the last ones stood\n",
            stale_pose, stale_gaze);
    if (const json governor = s.value("governor", json()); governor.is_object())
        text += fmt::format(
            "governor          {} changes{}\n", number(governor["changes"]),
            governor["error_paid"].is_number()
                ? fmt::format("; {} {} paid, {} with the dearest setting",
                              governor["error_name"].get<std::string>(),
                              number(governor["error_paid"]), number(governor["error_dearest"]))
                : "");
    const json& ratio = s["sampled_pixel_ratio"];
    text +=
        fmt::format("traced pixels     {} of all\n",
                    ratio.is_number() ? fmt::format("{:.1f} %", 100.0 * ratio.get<double>()) : "-");
    if (const json& recording = s.value("recording", json()); recording.is_object()) {
        text += fmt::format("recording         {} messages, {} dropped, {:.1f} MB\n",
                            recording["messages"].get<std::uint64_t>(),
                            recording["dropped"].get<std::uint64_t>(),
                            recording["bytes"].get<double>() * 1e-6);
    }
    if (const json& display = s.value("display", json()); display.is_object()) {
        text += fmt::format("shown on          {}; vsyncs from the {}, known to {}\n",
                            display["shown_on"].get<std::string>(),
                            display["vsync_from"].get<std::string>(),
                            number(display["vsync_error_ms"], " ms"));
        if (const auto frames_with = display["hud_frames"].get<std::uint64_t>(); frames_with > 0)
            text += fmt::format("hud               its cost is in {} frames\n", frames_with);
    }
    text += losses(s.value("devices", json::object()));
    text += outages(s.value("devices", json::object()));
    for (const json& image : s.value("images", json::array())) {
        if (!image.contains("mean_absolute_error")) continue;
        text += fmt::format("error to full     {:.2f} % of full scale (frame {}, {} eye)\n",
                            100.0 * image["mean_absolute_error"].get<double>(),
                            image["frame"].get<std::int64_t>(), image["eye"].get<std::string>());
    }
    return text;
}

std::string plan_text(const json& plan) {
    std::string text;
    for (const json& effect : plan) {
        const bool on = effect["on"].get<bool>();
        text += fmt::format("{:<18} {:<4} {}\n", effect["effect"].get<std::string>(),
                            on ? "on" : "off", effect["because"].get<std::string>());
        if (!on) continue;
        std::string passes;
        for (const json& pass : effect["passes"]) {
            passes += (passes.empty() ? "" : ", ") + pass.get<std::string>();
        }
        text += fmt::format("{:<23} passes: {}; memory: {}; {} a frame\n", "",
                            passes.empty() ? "none of its own" : passes, megabytes(effect["bytes"]),
                            number(effect["measured_ms"], " ms"));
    }
    return text;
}

}  // namespace foverig
