// Whether a VSync budget is held: a scenario too dear for this machine, alone and with the governor
// walking five settings that this machine has timed. In lockstep with measured cost, so that only
// the renderer's time counts.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/on_devices.h"
#include "bench/statistics.h"
#include "bench/suites.h"
#include "rig/governor/governed_renderer.h"
#include "rig/open_scene.h"
#include "rig/records/columns.h"
#include "rig/records/vsync_count.h"
#include "rig/scenario/parse.h"
#include "rig/session/session.h"

namespace foverig::bench {
namespace {

constexpr double kUnguarded = 1.5;  ///< VSyncs that the dearest setting is sized to take
constexpr int kSizingFrames = 24, kFrames = 1500;

struct Setting {
    double r0_deg, r1_deg, p_min;
    int samples;
};
/// Cheapest first; the dearest traces every pixel.
constexpr Setting kSettings[] = {
    {2, 6, 0.01, 1}, {5, 10, 0.02, 2}, {5, 15, 0.05, 4}, {10, 20, 0.2, 8}, {10, 20, 1.0, 16}};

RenderSettings with(RenderSettings render, const Setting& s) {
    render.foveation = {.r0_deg = s.r0_deg, .r1_deg = s.r1_deg, .p_min = s.p_min};
    if (render.lighting.area_samples > 0) render.lighting.area_samples = s.samples;
    if (render.lighting.ao_samples > 0) render.lighting.ao_samples = s.samples;
    return render;
}

Scenario scenario_of(const char* scene, int area_samples, int ao_samples) {
    Scenario s;
    s.scene = scene;
    s.render.backend = "embree";
    s.render.threads = 1;
    s.render.lighting.area_samples = area_samples;
    s.render.lighting.ao_samples = ao_samples;
    s.display.eyes = 1;
    s.display.distortion = false;
    s.images.count = 0;
    return s;
}

void set_width(Scenario& s, double width_px) {
    s.display.eye_width_px = static_cast<int>(std::lround(width_px));
    s.display.eye_height_px = static_cast<int>(std::lround(width_px * 1464.0 / 1182.0));
}

double budget_ms(const Scenario& s) {
    return 1000.0 / s.display.rate_hz;
}

using FrameDone = std::function<void(const FrameRecord&)>;

RunRecord run(Scenario scenario, const Scene& scene, Renderer& renderer, int frames,
              const FrameDone& done = {}) {
    scenario.frames = frames;
    complete_scenario(scenario);
    Session session(scenario, scene, renderer, nullptr);
    SessionHooks hooks;
    hooks.frame_done = [&](const FrameRecord& frame, const FrameInput&, double) {
        if (done) done(frame);
        return false;
    };
    return session.run(hooks);
}

std::vector<double> frame_times_ms(const RunRecord& run) {
    std::vector<double> times_ms;
    for (const FrameRecord& frame : run.frames) times_ms.push_back(frame_time_ms(frame));
    return times_ms;
}

double typical_ms(const Scenario& scenario, const std::shared_ptr<const Scene>& scene,
                  const Setting& setting) {
    const auto renderer = open_renderer(scene, with(scenario.render, setting));
    return median(frame_times_ms(run(scenario, *scene, *renderer, kSizingFrames)));
}

/// The width at which the dearest setting takes kUnguarded VSyncs, found in steps, as a frame has
/// work that does not grow with its pixels.
void size_for_this_machine(Scenario& scenario, const std::shared_ptr<const Scene>& scene) {
    double width_px = 160.0;
    for (int step = 0; step < 3; ++step) {
        set_width(scenario, width_px);
        const double ms = typical_ms(scenario, scene, std::end(kSettings)[-1]);
        width_px =
            std::clamp(width_px * std::sqrt(kUnguarded * budget_ms(scenario) / ms), 48.0, 1182.0);
    }
    set_width(scenario, width_px);
}

governor::Ladder ladder_of(const Scenario& scenario, const std::shared_ptr<const Scene>& scene) {
    governor::Ladder ladder;
    for (const Setting& s : kSettings) {
        ladder.rungs.push_back({fmt::format("p_min {}, {} samples", s.p_min, s.samples),
                                with(scenario.render, s),
                                typical_ms(scenario, scene, s),
                                {}});
    }
    std::ranges::stable_sort(ladder.rungs, {}, &governor::Rung::ms);
    return ladder;
}

Json row_of(const RunRecord& run) {
    const VsyncCount count = count_vsyncs(run.frames);
    auto times_ms = frame_times_ms(run);
    std::ranges::sort(times_ms);
    const auto at = [&](double share) {
        return times_ms[static_cast<std::size_t>(share * static_cast<double>(times_ms.size() - 1))];
    };
    return {{"vsyncs", count.total},
            {"missed", count.missed},
            {"missed_ratio", static_cast<double>(count.missed) / static_cast<double>(count.total)},
            {"p50_ms", at(0.5)},
            {"p99_ms", at(0.99)}};
}

/// Empty where all is right.
std::string wrong(const RunRecord& run, const VsyncCount& count) {
    if (run.frames.size() != kFrames) return "frames are missing";
    if (count.total != count.presented + count.missed) return "VSyncs do not add up";
    if (count.rendered != count.presented + count.dropped) return "frames do not add up";
    for (const FrameRecord& frame : run.frames) {
        if (frame.numerics.nan > 0) return "a kernel met NaN";
    }
    if (std::ranges::count_if(run.frames, &FrameRecord::pose_stale) > kFrames / 100)
        return "the headset was not there";
    return "";
}

void bm_vsync(benchmark::State& state, Bench& bench, const std::string& name, Scenario scenario) {
    const auto scene = open_scene(scenario);
    for (auto _ : state) {
        size_for_this_machine(scenario, scene);
        governor::Ladder ladder = ladder_of(scenario, scene);
        const auto alone = open_renderer(scene, ladder.rungs.back().render);
        const Scenario measured = on_devices(scenario, bench.options);
        const RunRecord unguarded = run(measured, *scene, *alone, kFrames);
        governor::GovernedRenderer governed(
            ladder, governor::limits_of(scenario),
            [&](const RenderSettings& settings) { return open_renderer(scene, settings); });
        const RunRecord held =
            run(measured, *scene, governed, kFrames,
                [&](const FrameRecord& frame) { governed.frame_took(frame_time_ms(frame)); });
        for (const RunRecord* each : {&unguarded, &held}) {
            if (const auto why = wrong(*each, count_vsyncs(each->frames)); !why.empty()) {
                return state.SkipWithError(why.c_str());
            }
        }
        Json row{{"devices", bench.options.devices},
                 {"eye_width_px", scenario.display.eye_width_px},
                 {"eye_height_px", scenario.display.eye_height_px},
                 {"budget_ms", budget_ms(scenario)},
                 {"alone", row_of(unguarded)},
                 {"governed", row_of(held)}};
        std::vector<int> frames(ladder.rungs.size());
        for (const std::uint32_t chosen : governed.chosen()) ++frames[chosen];
        for (std::size_t i = 0; i < frames.size(); ++i) {
            row["settings"].push_back({{"setting", ladder.rungs[i].text},
                                       {"ms", ladder.rungs[i].ms},
                                       {"frames", frames[i]}});
        }
        state.counters["missed_alone"] = row["alone"]["missed_ratio"].get<double>();
        state.counters["missed_governed"] = row["governed"]["missed_ratio"].get<double>();
        state.counters["p50_governed_ms"] = row["governed"]["p50_ms"].get<double>();
        bench.results.add("vsync", name, std::move(row));
    }
}

}  // namespace

void register_vsync(Bench& bench) {
    const std::pair<const char*, Scenario> cases[] = {
        {"cornell, occlusion", scenario_of("cornell", 0, 16)},
        {"cornell, area light", scenario_of("cornell", 16, 0)},
        {"atrium, occlusion", scenario_of("atrium", 0, 16)}};
    for (const auto& [name, scenario] : cases) {
        benchmark::RegisterBenchmark(
            (std::string("BM_Vsync/") + name).c_str(),
            [&bench, name = std::string(name), scenario = scenario](benchmark::State& state) {
                bm_vsync(state, bench, name, scenario);
            })
            ->Iterations(1)
            ->Unit(benchmark::kSecond);
    }
}

}  // namespace foverig::bench
