// Bar 5: how far the foveated image is from the full one of the same frame, over a flight of
// consecutive frames. Inside r0 it is promised to be equal; outside, small on average.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "bench/flight.h"
#include "bench/image_error.h"
#include "bench/statistics.h"
#include "bench/suites.h"

namespace foverig::bench {
namespace {

struct Errors {
    std::uint64_t inside_pixels = 0;
    std::uint64_t inside_equal = 0;
    double inside_max = 0.0;
    std::uint64_t not_finite = 0;
    std::vector<double> outside_means;
    std::vector<double> whole_means;
    int worst_frame = 0;

    void add(int frame, const ImageError& e) {
        inside_pixels += e.inside_pixels;
        inside_equal += e.inside_equal;
        inside_max = std::max(inside_max, e.inside_max);
        not_finite += e.not_finite;
        if (outside_means.empty() || e.outside_mean > largest(outside_means)) worst_frame = frame;
        outside_means.push_back(e.outside_mean);
        whole_means.push_back(e.whole_mean);
    }
};

void run(benchmark::State& state, Bench& bench, const std::string& scene, Load load) {
    const Case subject = bench.scenes.take(scene, load);
    RenderSettings settings = subject.settings;
    settings.pipeline = "full";
    const auto full = make_renderer(subject.scene, settings);
    settings.pipeline = "reprojected";
    const auto ours = make_renderer(subject.scene, settings);
    const Flight flight(*subject.scene);
    const int first = std::max(0, (flight.frame_count() - bench.options.error_frames) / 2);
    const int stride = load == Load::point ? 1 : bench.options.error_stride;
    Errors errors;
    std::uint64_t counted_bad = 0;
    int step = 0;
    for (auto unused : state) {
        const int at = first + step;
        const FrameInput input = flight.frame(at);
        const FrameStats stats = ours->render(input);
        counted_bad += stats.numerics.nan + stats.numerics.inf;
        state.SetIterationTime(stats.render_ms * 1e-3);
        // The first frame has no history: it is not a frame of a flight.
        if (step > 0 && step % stride == 0) {
            counted_bad += full->render(input).numerics.nan;
            errors.add(at, image_error(ours->image(0), full->image(0), input.eyes[0],
                                       settings.foveation.r0_deg));
        }
        ++step;
    }
    const double equal_share =
        static_cast<double>(errors.inside_equal) /
        static_cast<double>(std::max<std::uint64_t>(1, errors.inside_pixels));
    Json row = {{"scene", scene},
                {"load", name_of(load)},
                {"frames", step},
                {"compared_frames", errors.outside_means.size()},
                {"inside_r0_equal_share", equal_share},
                {"inside_r0_max_difference", errors.inside_max},
                {"outside_r0_mean", mean(errors.outside_means)},
                {"outside_r0_worst_frame_mean", largest(errors.outside_means)},
                {"worst_frame", errors.worst_frame},
                {"whole_image_mean", mean(errors.whole_means)},
                {"nan_or_inf", errors.not_finite + counted_bad}};
    if (!subject.note.empty()) row["note"] = subject.note;
    for (const char* key : {"inside_r0_equal_share", "inside_r0_max_difference", "outside_r0_mean",
                            "outside_r0_worst_frame_mean"})
        state.counters[key] = row[key].get<double>();
    state.counters["nan_or_inf"] = static_cast<double>(errors.not_finite + counted_bad);
    state.SetLabel(subject.note);
    bench.results.add("reprojection_error", fmt::format("{}/{}", scene, name_of(load)), row);
}

}  // namespace

void register_reprojection_error(Bench& bench) {
    for (const std::string& scene : scene_names()) {
        for (const Load load : {Load::point, Load::area8, Load::ao16_short}) {
            benchmark::RegisterBenchmark(
                fmt::format("BM_ReprojectionError/{}/{}", scene, name_of(load)).c_str(),
                [&bench, scene, load](benchmark::State& state) { run(state, bench, scene, load); })
                ->Iterations(bench.options.error_frames)
                ->UseManualTime()
                ->Unit(benchmark::kMillisecond);
        }
    }
}

}  // namespace foverig::bench
