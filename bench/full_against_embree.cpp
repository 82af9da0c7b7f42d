// Bar 3: rays per second of the renderer's ray passes over those of bare Embree loops on the same
// rays, scene handle, threads and tiles; turns taken in one process, ratio of medians.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "bench/anchor.h"
#include "bench/flight.h"
#include "bench/statistics.h"
#include "bench/suites.h"
#include "bench/traced_frame.h"

namespace foverig::bench {
namespace {

constexpr double kMostWrong = 1.0e-4;  ///< of rays whose answer may differ between calls
constexpr int kHistoryFrames = 10;     ///< before a foveated list is taken

/// How many tiles are left out, so that prepared rays stay within some hundred MB.
int tile_stride(Load load) {
    if (load == Load::point) return 1;
    return load == Load::area8 ? 2 : 4;
}

const char* pass_of(Load load) {
    if (load == Load::point) return "shadow_point";
    return load == Load::area8 ? "shadow_area" : "ambient_occlusion";
}

double pass_ms(const FrameStats& stats, const std::string& name) {
    for (const PassTime& pass : stats.passes)
        if (pass.name == name) return pass.ms;
    return 0.0;
}

/// Times of one side over the repetitions, and of each variant of the other.
struct Race {
    std::uint64_t rays = 0;
    std::vector<double> ours_ms;
    std::vector<std::vector<double>> anchors_ms;
    std::vector<std::string> names;

    Json row() const {
        Json variants = Json::object();
        double best_ms = 0.0;
        std::string best;
        for (std::size_t i = 0; i < names.size(); ++i) {
            const double ms = median(anchors_ms[i]);
            variants[names[i]] = mrays_s(ms);
            if (best.empty() || ms < best_ms) {
                best_ms = ms;
                best = names[i];
            }
        }
        return {{"rays", rays},
                {"repetitions", ours_ms.size()},
                {"mrays_s", mrays_s(median(ours_ms))},
                {"anchor", best},
                {"anchor_mrays_s", mrays_s(best_ms)},
                {"share_of_anchor", best_ms / median(ours_ms)},
                {"anchors_mrays_s", variants}};
    }
    double mrays_s(double ms) const { return static_cast<double>(rays) / ms * 1e-3; }
};

template <class Anchor>
Race race_with(std::span<const Anchor> anchors, std::uint64_t rays) {
    Race race;
    race.rays = rays;
    for (const Anchor& anchor : anchors) race.names.emplace_back(anchor.name);
    race.anchors_ms.resize(anchors.size());
    return race;
}

template <class Anchor, class Tiles>
void run_all(Race& race, CpuBackend& backend, std::span<const Anchor> anchors, const Tiles& tiles) {
    for (std::size_t i = 0; i < anchors.size(); ++i)
        race.anchors_ms[i].push_back(run_anchor(backend, anchors[i], std::span(tiles)).busy_ms);
}

template <class Tiles>
std::uint64_t rays_in(const Tiles& tiles, auto count) {
    std::uint64_t sum = 0;
    for (const auto& tile : tiles) sum += static_cast<std::uint64_t>(count(tile));
    return sum;
}

/// Empty where every call agrees with the renderer's own packets; else what does not.
std::string disagreement(PipelineCore& core, TracedFrame& frame,
                         const std::vector<RayList>& lists) {
    for (const PrimaryAnchor& anchor : primary_anchors()) {
        const double wrong = frame.wrong_primary_share(anchor);
        if (wrong > kMostWrong)
            return fmt::format("{}: {} of the answers differ", anchor.name, wrong);
    }
    const auto expected = static_cast<double>(frame.occluded_by_packets());
    for (const OcclusionAnchor& anchor : occlusion_anchors()) {
        const auto found =
            static_cast<double>(run_anchor(core.backend(), anchor, std::span(lists)).occluded);
        const auto rays =
            static_cast<double>(rays_in(lists, [](const RayList& l) { return l.count(); }));
        if (std::abs(found - expected) > kMostWrong * rays)
            return fmt::format("{}: {} rays occluded instead of {}", anchor.name, found, expected);
    }
    return "";
}

/// Pixels that `reprojected` traces at the input's frame, its history filled by the frames before.
Mask foveated_pixels(const Case& subject, const Flight& flight, int frame) {
    RenderSettings settings = subject.settings;
    settings.pipeline = "reprojected";
    const auto renderer = make_renderer(subject.scene, settings);
    for (int i = frame - kHistoryFrames; i <= frame; ++i) renderer->render(flight.frame(i));
    return renderer->sampling_mask(0);
}

void run(benchmark::State& state, Bench& bench, const std::string& scene, Load load,
         bool foveated) {
    const Case subject = bench.scenes.take(scene, load);
    RenderSettings settings = subject.settings;
    settings.pipeline = "full";
    PipelineCore core(subject.scene, settings);
    const Flight flight(*subject.scene);
    const int at = flight.frame_count() / 3;
    Selection selection;
    if (foveated) selection.mask = foveated_pixels(subject, flight, at);
    selection.tile_stride = foveated ? 1 : tile_stride(load);
    selection.r0_deg = static_cast<float>(settings.foveation.r0_deg);
    TracedFrame frame(core, flight.frame(at), selection);
    const std::vector<RayList> lists = frame.visibility_rays();
    const std::string wrong = disagreement(core, frame, lists);
    if (!wrong.empty()) return state.SkipWithError(wrong.c_str());

    Race primary = race_with(primary_anchors(),
                             rays_in(frame.queues(), [](const PixelQueue& q) { return q.count; }));
    Race secondary =
        race_with(occlusion_anchors(), rays_in(lists, [](const RayList& l) { return l.count(); }));
    for (auto unused : state) {
        const FrameStats stats = frame.trace();
        primary.ours_ms.push_back(pass_ms(stats, "trace_primary"));
        secondary.ours_ms.push_back(pass_ms(stats, pass_of(load)));
        run_all(primary, core.backend(), primary_anchors(), frame.queues());
        run_all(secondary, core.backend(), occlusion_anchors(), lists);
        state.SetIterationTime(secondary.ours_ms.back() * 1e-3);
    }
    const char* const suite = foveated ? "foveated_list_against_embree" : "full_against_embree";
    for (const auto& [race, pass] :
         {std::pair(&primary, "trace_primary"), std::pair(&secondary, pass_of(load))}) {
        Json row = {{"scene", scene}, {"load", name_of(load)}, {"pass", pass}};
        row.update(race->row());
        if (!subject.note.empty()) row["note"] = subject.note;
        state.counters[fmt::format("{}_mrays_s", pass)] = row["mrays_s"].get<double>();
        state.counters[fmt::format("{}_share", pass)] = row["share_of_anchor"].get<double>();
        bench.results.add(suite, fmt::format("{}/{}/{}", scene, name_of(load), pass), row);
    }
    state.SetLabel(subject.note);
}

void add(Bench& bench, const char* name, bool foveated) {
    for (const std::string& scene : scene_names()) {
        for (const Load load : {Load::point, Load::area8, Load::ao16, Load::ao16_short}) {
            benchmark::RegisterBenchmark(
                fmt::format("{}/{}/{}", name, scene, name_of(load)).c_str(),
                [&bench, scene, load, foveated](benchmark::State& state) {
                    run(state, bench, scene, load, foveated);
                })
                ->Iterations(bench.options.repetitions)
                ->UseManualTime()
                ->Unit(benchmark::kMillisecond);
        }
    }
}

}  // namespace

void register_full_against_embree(Bench& bench) {
    add(bench, "BM_FullAgainstEmbree", false);
    add(bench, "BM_FoveatedListAgainstEmbree", true);
}

}  // namespace foverig::bench
