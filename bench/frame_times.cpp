// Frame times of every pipeline, on every backend of this machine, in every configuration that is
// one to that pipeline, small enough that all of them take two minutes. Each image is first held to
// Embree's of every pixel.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "bench/flight.h"
#include "bench/image_error.h"
#include "bench/pass_medians.h"
#include "bench/suites.h"
#include "renderer/scene/library.h"
#include "rig/scenario/foveation_configuration.h"

namespace foverig::bench {
namespace {

constexpr EyeSize kSize{296, 366};      // a sixteenth of a DK2 eye's pixels
constexpr int kWarmUpFrames = 8;        // that fill the history
constexpr double kLargestError = 0.02;  // of full scale, the bar of `reprojected` outside r0

struct Variant {
    std::string pipeline, scene, configuration, backend;

    std::string name() const {
        return fmt::format("{}/{}/{}/{}", pipeline, scene, configuration, backend);
    }
    RenderSettings settings(const Options& options) const {
        RenderSettings s;
        s.pipeline = pipeline;
        s.backend = backend;
        s.robust_tracing = options.robust;
        apply_foveation_configuration(configuration, s.foveation);
        return s;
    }
};

/// The same of every pixel with Embree: of the path-traced reference itself, else `full`.
RenderSettings judge_of(RenderSettings settings) {
    settings.backend = "embree";
    if (settings.pipeline != "reference") settings.pipeline = "full";
    return settings;
}

void run(benchmark::State& state, Bench& bench, const Variant& variant) {
    const auto scene = std::make_shared<const Scene>(make_builtin_scene(variant.scene));
    const RenderSettings settings = variant.settings(bench.options);
    const Flight flight(*scene, kSize);
    for (auto unused : state) {
        const auto renderer = make_renderer(scene, settings);
        for (int i = 0; i < kWarmUpFrames; ++i) renderer->render(flight.frame(i));
        const FrameInput proof = flight.frame(kWarmUpFrames - 1);
        const auto judge = make_renderer(scene, judge_of(settings));
        judge->render(proof);
        const ImageError error =
            image_error(renderer->image(0), judge->image(0), proof.eyes[0], 0.0);
        if (error.not_finite > 0) return state.SkipWithError("NaN or infinity in an image");
        if (error.whole_mean > kLargestError)
            return state.SkipWithError(
                fmt::format("differs from the whole image by {:.3f}", error.whole_mean).c_str());
        PassMedians medians;
        for (int i = 0; i < bench.options.frames; ++i)
            medians.render(*renderer, flight.frame(kWarmUpFrames + i));
        state.SetIterationTime(1e-3 * medians.frame_ms());
        state.counters["cpu_ms"] = medians.cpu_ms();
        state.counters["error"] = error.whole_mean;
        bench.results.add("frame_times", variant.name(),
                          {{"frames", bench.options.frames},
                           {"width_px", kSize.width_px},
                           {"height_px", kSize.height_px},
                           {"frame_ms", medians.frame_ms()},
                           {"cpu_ms", medians.cpu_ms()},
                           {"error", error.whole_mean},
                           {"passes_ms", medians.passes()}});
    }
}

/// Those that can be had here: CUDA where `auto` would take it.
std::vector<std::string> backends_of(const std::string& pipeline) {
    std::vector<std::string> names{"embree", "host-bvh"};
    RenderSettings settings;
    settings.pipeline = pipeline;
    if (const auto choice = choose_backend(settings); choice.name == "cuda")
        names.push_back(choice.name);
    return names;
}

std::vector<std::string> configurations_of(const std::string& pipeline) {
    if (pipeline == "full" || pipeline == "reference") return {"full"};
    return {"small", "medium", "large"};
}

}  // namespace

void register_frame_times(Bench& bench) {
    for (const std::string& pipeline : pipeline_names())
        for (const char* scene : {"cornell", "atrium"})
            for (const std::string& configuration : configurations_of(pipeline))
                for (const std::string& backend : backends_of(pipeline)) {
                    const Variant variant{pipeline, scene, configuration, backend};
                    benchmark::RegisterBenchmark(
                        ("BM_FrameTime/" + variant.name()).c_str(),
                        [&bench, variant](benchmark::State& state) { run(state, bench, variant); })
                        ->Iterations(1)
                        ->UseManualTime()
                        ->Unit(benchmark::kMillisecond);
                }
}

}  // namespace foverig::bench
