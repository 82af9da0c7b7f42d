#include "rig/report/live_strip.h"

#include <fmt/format.h>

#include "rig/report/scripts.h"

namespace foverig::report {
namespace {

/// 13 bytes each, in a page that stays below 6 MB; 11 minutes at 75 Hz.
constexpr std::size_t kMostFrames = 50'000;

using Column = std::vector<std::optional<double>>;

std::string json_array(const Column& values, int digits) {
    std::string text = "[";
    for (const auto& value : values) {
        if (text.size() > 1) text += ',';
        text += value ? fmt::format("{:.{}f}", *value, digits) : "null";
    }
    return text + "]";
}

/// One letter a frame: in time, late or dropped.
std::string fates(const Column& late, const Column& dropped) {
    std::string text;
    for (std::size_t i = 0; i < late.size(); ++i) {
        text += dropped[i].value_or(0.0) > 0.0 ? 'd' : late[i].value_or(0.0) > 0.0 ? 'l' : '.';
    }
    return text;
}

}  // namespace

std::string live_strip(const RunData& run) {
    const FrameTable& frames = run.frames;
    if (kStripScript.empty() || frames.frames == 0 || frames.frames > kMostFrames) return "";
    return fmt::format(
        "<div id=\"frame-strip\"></div><p class=\"live note\">Drag over a part or turn the wheel "
        "to see it closer; a double click shows all again.</p>"
        "<script type=\"application/json\" id=\"frame-data\">{{\"budget_ms\":{},"
        "\"warm_up_frames\":{},\"time_ms\":{},\"motion_to_photon_ms\":{},\"fate\":\"{}\"}}"
        "</script><style>{}</style><script>/*!\n{}*/\n{}\n{}</script>",
        run.number({"vsync", "budget_ms"}).value_or(0.0),
        run.number({"steady_frame_time_ms", "warm_up_frames"}).value_or(0.0),
        json_array(frames.column("frame_time_ms"), 3),
        json_array(frames.column("motion_to_photon_ms"), 2),
        fates(frames.column("late"), frames.column("dropped")), kUplotStyle, kUplotLicence,
        kUplotScript, kStripScript);
}

}  // namespace foverig::report
