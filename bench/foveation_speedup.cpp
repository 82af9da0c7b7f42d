// Bar 2: what foveation with reprojection gains over tracing every pixel, frame by frame on the
// same input, in one process. The telling number is speed-up over ray cut (PERFORMANCE.md 8.1 C6).
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "bench/flight.h"
#include "bench/pass_medians.h"
#include "bench/suites.h"

namespace foverig::bench {
namespace {

constexpr int kStretches = 6;     ///< of consecutive frames, spread over the flight
constexpr int kWarmUpFrames = 8;  ///< of each, that fill the history

struct Published {
    const char* scene;
    Load load;
    double speed_up;
    double ray_cut;
};

/// Weier 2016 Table 1 (PERFORMANCE.md 1.1).
constexpr Published kPublished[] = {
    {"sponza", Load::point, 1.92, 5.41},  {"sponza", Load::area8, 3.52, 5.38},
    {"sponza", Load::ao16, 4.18, 5.39},   {"sibenik", Load::point, 1.59, 4.27},
    {"sibenik", Load::area8, 2.64, 4.28}, {"sibenik", Load::ao16, 3.03, 4.28},
};

std::unique_ptr<Renderer> renderer_of(const Case& subject, const char* pipeline) {
    RenderSettings settings = subject.settings;
    settings.pipeline = pipeline;
    return make_renderer(subject.scene, settings);
}

struct Comparison {
    PassMedians full;
    PassMedians ours;
    std::vector<double> frame_speed_ups;
    std::vector<double> traced_ratios;
    std::vector<double> resampled_ratios;
    double full_rays = 0.0;
    double our_rays = 0.0;
    std::uint64_t bad_values = 0;

    void add(const FrameStats& f, const FrameStats& o, const Mask& resampled) {
        frame_speed_ups.push_back(f.render_ms / o.render_ms);
        traced_ratios.push_back(static_cast<double>(o.sampled_pixels) /
                                static_cast<double>(o.all_pixels));
        double marked = 0.0;
        for (const std::uint8_t m : resampled.pixels) marked += m;
        resampled_ratios.push_back(marked / static_cast<double>(o.all_pixels));
        full_rays += static_cast<double>(f.rays.total());
        our_rays += static_cast<double>(o.rays.total());
        bad_values += f.numerics.nan + f.numerics.inf + o.numerics.nan + o.numerics.inf;
    }
    double speed_up() const { return full.frame_ms() / ours.frame_ms(); }
    double ray_cut() const { return full_rays / our_rays; }
};

Json row_of(const Comparison& c, const std::string& scene, Load load) {
    const auto frames = static_cast<double>(c.traced_ratios.size());
    Json row = {{"scene", scene},
                {"load", name_of(load)},
                {"frames", c.traced_ratios.size()},
                {"traced_primary_ratio", median(c.traced_ratios)},
                {"traced_primary_ratio_max", largest(c.traced_ratios)},
                {"resampled_ratio", median(c.resampled_ratios)},
                {"mrays_full", c.full_rays / frames * 1e-6},
                {"mrays_ours", c.our_rays / frames * 1e-6},
                {"ray_cut", c.ray_cut()},
                {"frame_ms_full", c.full.frame_ms()},
                {"frame_ms_ours", c.ours.frame_ms()},
                {"speed_up", c.speed_up()},
                {"speed_up_median_of_frames", median(c.frame_speed_ups)},
                {"cpu_ms_full", c.full.cpu_ms()},
                {"cpu_ms_ours", c.ours.cpu_ms()},
                {"speed_up_cpu", c.full.cpu_ms() / c.ours.cpu_ms()},
                {"speed_up_per_ray_cut", c.speed_up() / c.ray_cut()},
                {"nan_or_inf", c.bad_values},
                {"passes_ms_full", c.full.passes()},
                {"passes_ms_ours", c.ours.passes()}};
    for (const Published& p : kPublished) {
        if (scene != p.scene || load != p.load) continue;
        row["weier_2016"] = {{"speed_up", p.speed_up},
                             {"ray_cut", p.ray_cut},
                             {"speed_up_per_ray_cut", p.speed_up / p.ray_cut}};
    }
    return row;
}

void run(benchmark::State& state, Bench& bench, const std::string& scene, Load load) {
    const Case subject = bench.scenes.take(scene, load);
    const auto full = renderer_of(subject, "full");
    const auto ours = renderer_of(subject, "reprojected");
    const Flight flight(*subject.scene);
    const int measured = std::max(1, bench.options.frames / kStretches);
    Comparison comparison;
    int stretch = 0;
    int step = 0;
    const auto first = [&] { return stretch * flight.frame_count() / kStretches; };
    for (auto unused : state) {
        if (step == 0) {
            full->render(flight.frame(first()));
            while (step < kWarmUpFrames) ours->render(flight.frame(first() + step++));
        }
        const FrameInput input = flight.frame(first() + step);
        // Turns taken, so that neither side is always the one with the warmer caches.
        FrameStats f;
        FrameStats o;
        if (step % 2 == 0) f = comparison.full.render(*full, input);
        o = comparison.ours.render(*ours, input);
        if (step % 2 != 0) f = comparison.full.render(*full, input);
        state.SetIterationTime(o.render_ms * 1e-3);
        comparison.add(f, o, ours->resampling_mask(0));
        if (++step >= kWarmUpFrames + measured) {
            step = 0;
            ++stretch;
        }
    }
    if (comparison.bad_values > 0) return state.SkipWithError("NaN or infinity in an image");
    Json row = row_of(comparison, scene, load);
    if (!subject.note.empty()) row["note"] = subject.note;
    state.SetLabel(subject.note);
    for (const char* key : {"frame_ms_full", "frame_ms_ours", "ray_cut", "speed_up",
                            "speed_up_per_ray_cut", "traced_primary_ratio"})
        state.counters[key] = row[key].get<double>();
    bench.results.add("foveation_speedup", fmt::format("{}/{}", scene, name_of(load)), row);
}

}  // namespace

void register_foveation_speedup(Bench& bench) {
    const int frames = std::max(1, bench.options.frames / kStretches) * kStretches;
    for (const std::string& scene : scene_names()) {
        for (const Load load : {Load::point, Load::area8, Load::ao16, Load::ao16_short}) {
            const std::string name = fmt::format("BM_FoveationSpeedup/{}/{}", scene, name_of(load));
            benchmark::RegisterBenchmark(
                name.c_str(),
                [&bench, scene, load](benchmark::State& state) { run(state, bench, scene, load); })
                ->Iterations(frames)
                ->UseManualTime()
                ->Unit(benchmark::kMillisecond);
        }
    }
}

}  // namespace foverig::bench
