#include "rig/report/overview.h"

#include <fmt/format.h>

#include "rig/records/elsewhere.h"
#include "rig/report/markup.h"
#include "rig/report/provenance.h"

namespace foverig::report {
namespace {

std::string tile(const std::string& what, const std::string& value, const std::string& more) {
    return fmt::format("<div class=\"tile\"><span>{}</span><b>{}</b><small>{}</small></div>", what,
                       value, more);
}

std::string milliseconds(const std::optional<double>& ms) {
    return ms ? number(ms) + "\u202fms" : number(ms);
}

/// What a verdict cannot blame the renderer for.
std::string not_alone(const RunData& run) {
    const std::string elsewhere = elsewhere_text(run.summary);
    if (elsewhere.empty()) return "";
    return fmt::format(" Meanwhile went elsewhere, of the machine, {}.", escaped(elsewhere));
}

std::string verdict(const RunData& run) {
    const auto missed = run.number({"vsync", "missed"});
    const auto total = run.number({"vsync", "total"});
    const double rate_hz = run.number({"vsync", "rate_hz"}).value_or(0.0);
    const double nan = run.number({"numerics", "nan"}).value_or(0.0);
    if (nan > 0.0) {
        return fmt::format("<p class=\"verdict bad\">Not valid: kernels met NaN {} times.</p>",
                           number(nan));
    }
    if (!missed || !total || *total == 0.0) {
        return "<p class=\"verdict bad\">No frame was shown.</p>";
    }
    const std::string basis = fmt::format("frame time p50 {}, p99 {}; budget {}",
                                          milliseconds(run.number({"frame_time_ms", "p50"})),
                                          milliseconds(run.number({"frame_time_ms", "p99"})),
                                          milliseconds(run.number({"vsync", "budget_ms"})));
    if (*missed == 0.0) {
        return fmt::format(
            "<p class=\"verdict\"><b>Holds {:g} Hz</b>: a new frame at each of {} "
            "VSyncs ({}).</p>",
            rate_hz, count(total), basis);
    }
    return fmt::format(
        "<p class=\"verdict bad\"><b>Does not hold {:g} Hz</b>: {} of {} VSyncs had "
        "no new frame ({}).{}</p>",
        rate_hz, count(missed), count(total), basis, not_alone(run));
}

std::string median_interval(const RunData& run) {
    const auto& spread = run.summary["frame_time_ms"];
    if (!spread.is_object() || !spread["p50_ci95"].is_array()) return "p50";
    return fmt::format("p50, 95 % of {} to {}", number(spread["p50_ci95"][0].get<double>()),
                       number(spread["p50_ci95"][1].get<double>()));
}

std::string tiles(const RunData& run) {
    const auto latency = [&](const char* name, const char* what) {
        return tile(
            what, milliseconds(run.number({"latency_ms", name, "p50"})),
            fmt::format("p50; p99 {}", milliseconds(run.number({"latency_ms", name, "p99"}))));
    };
    std::string html = "<div class=\"tiles\">";
    html += tile("frame time", milliseconds(run.number({"frame_time_ms", "p50"})),
                 median_interval(run));
    html += tile("VSyncs missed", percent(run.number({"vsync", "missed_ratio"})),
                 fmt::format("{} of {}", count(run.number({"vsync", "missed"})),
                             count(run.number({"vsync", "total"}))));
    html += latency("motion_to_photon", "motion to photon");
    html += latency("gaze_to_photon", "gaze to photon");
    html += tile("traced pixels", percent(run.number({"sampled_pixel_ratio"})), "of all pixels");
    html += tile("rays", count(run.number({"rays", "total"})),
                 fmt::format("a frame, {} primary", count(run.number({"rays", "primary"}))));
    html += tile(
        "frames", count(run.number({"frames", "rendered"})),
        fmt::format("{} shown, {} dropped, {} late, {} mis-presented: at another VSync than the "
                    "picture is of",
                    count(run.number({"frames", "presented"})),
                    count(run.number({"frames", "dropped"})), count(run.number({"frames", "late"})),
                    count(run.number({"frames", "mis_presented"}))));
    const auto error_deg = run.number({"latency_ms", "prediction_error_deg", "p99"});
    html += tile("prediction error", error_deg ? number(error_deg) + "°" : number(error_deg),
                 "p99, head pose at the photon");
    return html + "</div>";
}

/// Frames that show where nobody looked.
std::string lost_tracking(const RunData& run) {
    const auto pose = run.number({"tracking", "pose_stale_frames"}).value_or(0.0);
    const auto gaze = run.number({"tracking", "gaze_stale_frames"}).value_or(0.0);
    if (pose + gaze == 0.0) return "";
    return fmt::format(
        "<p class=\"verdict bad\"><b>Tracking was lost</b>: the head pose was stale in {} frames, "
        "the gaze in {}; the last ones stood.</p>",
        count(pose), count(gaze));
}

}  // namespace

std::string title(const RunData& run) {
    const std::filesystem::path scene = run.text({"scenario", "scene"});
    return scene.filename().string() + " · " + run.text({"pipeline"});
}

std::string overview(const RunData& run) {
    std::string html = fmt::format("<h1>{}</h1>", escaped(title(run)));
    const auto clock = run.text({"scenario", "clock"});
    html += fmt::format(
        "<p class=\"identity\">foverig {} ({}) · {} · {}, {} floating point · backend {} · {}, {} "
        "cores · {} · clock {}, cost {}{}</p>",
        escaped(run.text({"build", "version"})), escaped(run.text({"build", "git"})),
        escaped(run.text({"build", "compiler"})), escaped(run.text({"build", "type"})),
        escaped(run.text({"build", "fp_mode"})), escaped(run.text({"build", "backend"})),
        escaped(run.text({"host", "cpu"})), count(run.number({"host", "cores"})),
        escaped(run.text({"host", "os"})), escaped(clock), escaped(run.text({"scenario", "cost"})),
        run.summary.value("interrupted", false) ? " · <b>ended early by Ctrl-C</b>" : "");
    html += fmt::format("<p class=\"identity\">{}</p>", escaped(provenance(run)));
    return html + verdict(run) + lost_tracking(run) + tiles(run);
}

}  // namespace foverig::report
