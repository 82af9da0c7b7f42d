// What the rig itself adds between the newest sample and the display: a session whose renderer
// draws nothing, in lockstep with measured cost.
#include <benchmark/benchmark.h>

#include <algorithm>

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

double at_share(const std::vector<double>& sorted, double share) {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

/// Empty where all is right.
std::string wrong(const RunRecord& run) {
    const VsyncCount count = count_vsyncs(run.frames);
    if (count.rendered != kFrames || count.presented + count.dropped != count.rendered)
        return "frames are missing";
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
    complete_scenario(scenario);
    const auto scene = open_scene(scenario);
    for (auto _ : state) {
        NoRenderer idle;
        Session session(scenario, *scene, idle, nullptr);
        const RunRecord run = session.run({});
        if (const auto why = wrong(run); !why.empty()) return state.SkipWithError(why.c_str());
        std::vector<double> times_us;
        for (const FrameRecord& frame : run.frames) times_us.push_back(1e3 * frame_time_ms(frame));
        std::ranges::sort(times_us);
        const double p50_us = at_share(times_us, 0.5), p99_us = at_share(times_us, 0.99);
        state.SetIterationTime(1e-6 * p50_us);
        state.counters["p50_us"] = p50_us;
        state.counters["p99_us"] = p99_us;
        bench.results.add("rig_latency", "pose to present",
                          {{"frames", kFrames}, {"p50_us", p50_us}, {"p99_us", p99_us}});
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
