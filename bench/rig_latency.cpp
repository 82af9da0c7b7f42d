// What the rig itself adds between the newest sample and the display: a session whose renderer
// draws nothing, in lockstep with measured cost or, with the devices on the desk, in real time.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "bench/on_devices.h"
#include "bench/suites.h"
#include "rig/open_scene.h"
#include "rig/records/columns.h"
#include "rig/records/vsync_count.h"
#include "rig/scenario/parse.h"
#include "rig/session/no_renderer.h"
#include "rig/session/session.h"

namespace foverig::bench {
namespace {

constexpr int kFrames = 3000;
constexpr double kPredicted_deg = 0.5;  ///< the simulated head's poses are known better than that

/// Of a frame, as they are called before "p50_us": begin to present has no name of its own.
constexpr std::pair<const char*, std::optional<double> (*)(const FrameRecord&)> kLatencies[] = {
    {"", [](const FrameRecord& frame) { return std::optional(frame_time_ms(frame)); }},
    {"imu_transport_", imu_transport_ms},
    {"gaze_transport_", gaze_transport_ms},
    {"motion_to_photon_", motion_to_photon_ms}};

double at_share(const std::vector<double>& sorted, double share) {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

/// Empty where all is right.
std::string wrong(const RunRecord& run) {
    const VsyncCount count = count_vsyncs(run.frames);
    if (count.rendered != kFrames || count.presented + count.dropped != count.rendered)
        return "frames are missing";
    const auto stale = std::ranges::count_if(run.frames, &FrameRecord::pose_stale);
    if (stale > kFrames / 100) return "the headset was not there";
    if (run.devices.front().origin == Origin::hardware) return "";  // nobody knows its poses
    std::vector<double> error_deg;
    for (const FrameRecord& frame : run.frames)
        if (frame.prediction_error_deg) error_deg.push_back(*frame.prediction_error_deg);
    std::ranges::sort(error_deg);
    if (error_deg.size() < kFrames / 2 || at_share(error_deg, 0.99) > kPredicted_deg)
        return "the poses are not the head's";
    return "";
}

/// From begin to present: what devices sent since the last frame (which the simulators make within
/// that time), decoding, fusion, both eyes' poses, records, the hand-over.
void bm_pose_to_present(benchmark::State& state, Bench& bench) {
    Scenario scenario;
    scenario.scene = "cornell";
    scenario.scene_detail = 0.1;
    scenario.frames = kFrames;
    scenario.display.distortion = false;
    scenario = on_devices(scenario, bench.options);
    complete_scenario(scenario);
    const auto scene = open_scene(scenario);
    for (auto _ : state) {
        NoRenderer idle;
        Session session(scenario, *scene, idle, nullptr);
        const RunRecord run = session.run({});
        if (const auto why = wrong(run); !why.empty()) return state.SkipWithError(why.c_str());
        Json row = {{"devices", bench.options.devices}, {"frames", kFrames}};
        const auto add = [&](const std::string& name, double share, std::vector<double> sorted) {
            if (sorted.empty()) return;
            std::ranges::sort(sorted);
            state.counters[name] = row[name] = at_share(sorted, share);
        };
        for (const auto& [name, of] : kLatencies) {
            std::vector<double> us;
            for (const FrameRecord& frame : run.frames)
                if (const auto ms = of(frame)) us.push_back(1e3 * *ms);
            add(name + std::string("p50_us"), 0.5, us);
            add(name + std::string("p99_us"), 0.99, us);
        }
        state.SetIterationTime(1e-6 * row["p50_us"].get<double>());
        bench.results.add("rig_latency", "pose to present", row);
    }
}

}  // namespace

void register_rig_latency(Bench& bench) {
    benchmark::RegisterBenchmark(
        "BM_PoseToPresent", [&bench](benchmark::State& state) { bm_pose_to_present(state, bench); })
        ->Iterations(1)
        ->UseManualTime()
        ->Unit(benchmark::kMicrosecond);
}

}  // namespace foverig::bench
