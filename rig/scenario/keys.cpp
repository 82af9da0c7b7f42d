#include "rig/scenario/keys.h"

#include "rig/scenario/cost.h"
#include "rig/scenario/governor_keys.h"
#include "rig/scenario/hardware_keys.h"
#include "rig/scenario/key_makers.h"
#include "rig/scenario/render_keys.h"
#include "rig/scenario/see_through_keys.h"
#include "rig/scenario/simulation_keys.h"
#include "rig/scenario/window_keys.h"
#include "rig/scenario/world_keys.h"
#include "rig/text/nearest.h"

namespace foverig {
namespace {

std::optional<std::string> known_devices(const std::string& devices) {
    const bool replay = devices.starts_with("replay:") && devices.size() > 7;
    if (devices == "sim" || devices == "hardware" || replay) return std::nullopt;
    return "sim, hardware or replay:FILE";
}

Key devices_key() {
    Key key = text_key(
        "devices", "sim, hardware or replay:FILE",
        "where the bytes of the devices come from: models, what is plugged in, or a recording",
        [](auto& s) -> auto& { return s.devices; });
    key.set = [](Scenario& s, const KeyValue& v) {
        auto complaint = known_devices(std::get<std::string>(v));
        if (!complaint) s.devices = std::get<std::string>(v);
        return complaint;
    };
    return key;
}

Key cost_key() {
    Key key = text_key(
        "cost", "measured, or fixed:MS with MS from 0 to 10000",
        "what a frame costs on the lockstep clock; fixed makes runs repeat bit for bit",
        [](auto& s) -> auto& { return s.cost; });
    key.set = [expected = key.expected](Scenario& s,
                                        const KeyValue& v) -> std::optional<std::string> {
        if (!parse_cost(std::get<std::string>(v))) return expected;
        s.cost = std::get<std::string>(v);
        return std::nullopt;
    };
    return key;
}

Key image_frames_key() {
    const std::string expected =
        fmt::format("at most {} whole numbers of at least 0, as in [0, 50]", kMostKeptFrames);
    return {.name = "images.frames",
            .type = KeyType::integers,
            .expected = expected,
            .help = "keep images of exactly these frames; [] = images.count decides",
            .get = [](const Scenario& s) { return KeyValue(s.images.frames); },
            .set = [expected](Scenario& s, const KeyValue& v) -> std::optional<std::string> {
                const auto& frames = std::get<std::vector<std::int64_t>>(v);
                const bool valid = std::all_of(frames.begin(), frames.end(),
                                               [](std::int64_t frame) { return frame >= 0; });
                if (!valid || frames.size() > kMostKeptFrames) return expected;
                s.images.frames = frames;
                return std::nullopt;
            }};
}

void add_run_keys(std::vector<Key>& keys) {
    keys.push_back(text_key(
        "scene", "a built-in scene (foverig scenes) or a file",
        "what is looked at; a file is taken relative to the scenario",
        [](auto& s) -> auto& { return s.scene; }));
    keys.push_back(number_key(
        "scene_scale", "m per file unit", {1e-6, 1e6}, "0.001 for a file in millimetres",
        [](auto& s) -> auto& { return s.scene_scale; }));
    keys.push_back(number_key(
        "scene_detail", "", {0.001, 100.0}, "triangle count of a built-in scene, 1 = as documented",
        [](auto& s) -> auto& { return s.scene_detail; }));
    add_renderer_keys(keys);
    keys.push_back(devices_key());
    keys.push_back(choice_key(
        "clock", {"wall", "lockstep"},
        "wall: real time; lockstep: time moves by what each frame cost",
        [](auto& s) -> auto& { return s.clock; }));
    keys.push_back(cost_key());
    keys.push_back(integer_key(
        "frames", "", {0, 1e9}, "frames to render; 0 = until `seconds` (both 0: 90)",
        [](auto& s) -> auto& { return s.frames; }));
    keys.push_back(number_key(
        "seconds", "s", {0.0, 86'400.0}, "how long to run on the run's clock; 0 = until `frames`",
        [](auto& s) -> auto& { return s.seconds; }));
    keys.push_back(number_key(
        "settle_s", "s", {0.0, 60.0},
        "devices run this long before the first frame, so that clock maps "
        "and fusion have settled",
        [](auto& s) -> auto& { return s.settle_s; }));
}

void add_display_keys(std::vector<Key>& keys) {
    keys.push_back(choice_key(
        "display.kind", {"virtual", "window", "headset"},
        "what shows the frames: a simulated panel, a window, or the DK2's panel as a monitor; the "
        "latter two need clock = wall",
        [](auto& s) -> auto& { return s.display.kind; }));
    keys.push_back(number_key(
        "display.rate_hz", "Hz", {1.0, 1000.0},
        "VSync rate (DK2: 75); a window takes its monitor's where that is told",
        [](auto& s) -> auto& { return s.display.rate_hz; }));
    keys.push_back(integer_key(
        "display.eyes", "", {1, 2}, "1: the left eye only; 2: both",
        [](auto& s) -> auto& { return s.display.eyes; }));
    keys.push_back(integer_key(
        "display.eye_width_px", "px", {16, 8192}, "width of an eye's image (DK2: 1182)",
        [](auto& s) -> auto& { return s.display.eye_width_px; }));
    keys.push_back(integer_key(
        "display.eye_height_px", "px", {16, 8192}, "height of an eye's image (DK2: 1464)",
        [](auto& s) -> auto& { return s.display.eye_height_px; }));
    keys.push_back(flag_key(
        "display.distortion", "lens distortion with chromatic correction as a pass",
        [](auto& s) -> auto& { return s.display.distortion; }));
    keys.push_back(choice_key(
        "display.pacing", {"vsync", "free"},
        "vsync: begin a frame at a VSync; free: as soon as the last is done",
        [](auto& s) -> auto& { return s.display.pacing; }));
}

void add_output_keys(std::vector<Key>& keys) {
    keys.push_back(integer_key(
        "images.count", "", {0, kMostKeptFrames}, "frames to keep images of, spread over the run",
        [](auto& s) -> auto& { return s.images.count; }));
    keys.push_back(image_frames_key());
    keys.push_back(flag_key(
        "images.error", "render those frames again in full and keep the difference",
        [](auto& s) -> auto& { return s.images.error; }));
    keys.push_back(flag_key(
        "recording.enabled", "record the devices' bytes, samples and frames in session.mcap",
        [](auto& s) -> auto& { return s.recording.enabled; }));
    keys.push_back(flag_key(
        "recording.decoded", "samples beside the bytes, to plot them; false: a quarter of the size",
        [](auto& s) -> auto& { return s.recording.decoded; }));
    keys.push_back(choice_key(
        "recording.compression", {"none", "zstd"},
        "of the file's chunks; zstd: smaller, for some of a core's time",
        [](auto& s) -> auto& { return s.recording.compression; }));
    keys.push_back(number_key(
        "replay.speed", "", {0.01, 1000.0},
        "how fast a recording goes on the wall clock; lockstep goes as fast as possible",
        [](auto& s) -> auto& { return s.replay.speed; }));
    keys.push_back(flag_key(
        "replay.loop", "begin a recording again at its end",
        [](auto& s) -> auto& { return s.replay.loop; }));
}

std::vector<Key> make_keys() {
    std::vector<Key> keys;
    add_run_keys(keys);
    add_display_keys(keys);
    add_window_keys(keys);
    add_see_through_keys(keys);
    add_foveation_keys(keys);
    add_lighting_keys(keys);
    add_reprojection_keys(keys);
    add_reference_keys(keys);
    add_effect_keys(keys);
    add_light_keys(keys);
    add_camera_keys(keys);
    add_motion_keys(keys);
    add_governor_keys(keys);
    add_hardware_keys(keys);
    add_output_keys(keys);
    add_fault_keys(keys);
    return keys;
}

}  // namespace

const std::vector<Key>& scenario_keys() {
    static const std::vector<Key> keys = make_keys();
    return keys;
}

const Key* find_key(const std::string& name) {
    for (const Key& key : scenario_keys()) {
        if (key.name == name) return &key;
    }
    return nullptr;
}

std::string nearest_key(const std::string& unknown) {
    std::vector<std::string> names;
    for (const Key& key : scenario_keys()) names.push_back(key.name);
    return nearest(unknown, names);
}

}  // namespace foverig
