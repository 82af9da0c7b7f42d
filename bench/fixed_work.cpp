// Bar 4: the work of `reprojected` that traces nothing, as a share of `full`'s frame with one point
// light; its growth with the pixels; its bytes against a STREAM triad of the same run.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <array>

#include "bench/flight.h"
#include "bench/pass_bytes.h"
#include "bench/pass_medians.h"
#include "bench/stream_triad.h"
#include "bench/suites.h"

namespace foverig::bench {
namespace {

constexpr std::array kFixedPasses{"reproject_vertices",
                                  "measure_facing",
                                  "reproject_coarse",
                                  "mark_resampling",
                                  "reproject_raster",
                                  "reproject",
                                  "merge",
                                  "cache_update",
                                  "post_process"};
/// Passes whose work is moving images, and not geometry or search: what bandwidth can bound.
constexpr std::array kImagePasses{"reproject", "merge", "cache_update"};
constexpr int kFrames = 12;
constexpr int kWarmUpFrames = 8;
constexpr std::size_t kLargeTriad = std::size_t{256} << 20U;

struct Scale {
    const char* name;
    EyeSize size;
};
constexpr std::array<Scale, 3> kScales{
    {{"quarter", {591, 732}}, {"dk2", {1182, 1464}}, {"fourfold", {2364, 2928}}}};

template <class Names>
double sum_ms(const PassMedians& medians, const Names& names) {
    double sum = 0.0;
    for (const char* name : names) sum += medians.pass_ms(name);
    return sum;
}

struct Measured {
    PassMedians full;
    PassMedians ours;
    PassSizes sizes;
    std::uint64_t frames = 0;
};

/// Means over the frames go into `sizes`.
void add(Measured& m, const FrameStats& ours) {
    ++m.frames;
    m.sizes.samples += (static_cast<double>(ours.sampled_pixels) - m.sizes.samples) /
                       static_cast<double>(m.frames);
    m.sizes.pixels = static_cast<double>(ours.all_pixels);
}

Json bytes_row(const Measured& m, const TriadRates& large, const TriadRates& image_sized) {
    Json passes = Json::object();
    double image_bytes = 0.0;
    for (const PassBytes& b : pass_bytes(m.sizes)) {
        const double ms = m.ours.pass_ms(b.pass);
        if (ms <= 0.0) continue;
        passes[b.pass] = {{"ms", ms},
                          {"bytes_per_px", b.moved / m.sizes.pixels},
                          {"gathered_bytes_per_px", b.gathered / m.sizes.pixels},
                          {"gb_s", b.moved / ms * 1e-6},
                          {"gathered_gb_s", b.gathered / ms * 1e-6}};
        for (const char* name : kImagePasses)
            if (std::string_view(name) == b.pass) image_bytes += b.moved;
    }
    const double gb_s = image_bytes / sum_ms(m.ours, kImagePasses) * 1e-6;
    return {{"passes", passes},
            {"image_passes_bytes_per_px", image_bytes / m.sizes.pixels},
            {"image_passes_gb_s", gb_s},
            {"triad_gb_s", large.plain_gb_s},
            {"triad_non_temporal_gb_s", large.non_temporal_gb_s},
            {"triad_image_sized_gb_s", image_sized.plain_gb_s},
            {"share_of_triad", gb_s / large.plain_gb_s}};
}

double support_cells(const EyeSize& size) {
    return size.width_px * 256.0 / 1182.0 * size.height_px * 318.0 / 1464.0;
}

void run(benchmark::State& state, Bench& bench, const std::string& scene, const Scale& scale) {
    const Case subject = bench.scenes.take(scene, Load::point);
    RenderSettings settings = subject.settings;
    settings.pipeline = "full";
    const auto full = make_renderer(subject.scene, settings);
    settings.pipeline = "reprojected";
    const auto ours = make_renderer(subject.scene, settings);
    const Flight flight(*subject.scene, scale.size);
    const int first = flight.frame_count() / 3;
    for (int i = 0; i < kWarmUpFrames; ++i) ours->render(flight.frame(first + i));
    full->render(flight.frame(first));
    Measured m;
    m.sizes.support_cells = support_cells(scale.size);
    m.sizes.taps = subject.settings.reprojection.footprint_samples;
    int frame = first + kWarmUpFrames;
    for (auto unused : state) {
        const FrameInput input = flight.frame(frame++);
        const FrameStats o = m.ours.render(*ours, input);
        m.full.render(*full, input);
        add(m, o);
        state.SetIterationTime(o.render_ms * 1e-3);
    }
    CpuBackend threads(*subject.scene, embree::EmbreeSettings{});
    const auto image_bytes = static_cast<std::size_t>(m.sizes.pixels) * 12;
    const Json bytes =
        bytes_row(m, stream_triad(threads, kLargeTriad, 5), stream_triad(threads, image_bytes, 9));
    const double fixed_ms = sum_ms(m.ours, kFixedPasses);
    Json row = {
        {"scene", scene},
        {"scale", scale.name},
        {"width_px", scale.size.width_px},
        {"height_px", scale.size.height_px},
        {"frame_ms_full", m.full.frame_ms()},
        {"frame_ms_ours", m.ours.frame_ms()},
        {"fixed_ms", fixed_ms},
        {"fixed_ns_per_px", fixed_ms * 1e6 / m.sizes.pixels},
        {"share_of_full_frame", fixed_ms / m.full.frame_ms()},
        {"select_and_store_ms", m.ours.pass_ms("select_pixels") + m.ours.pass_ms("store_samples")},
        {"passes_ms_ours", m.ours.passes()},
        {"traffic", bytes}};
    if (!subject.note.empty()) row["note"] = subject.note;
    for (const char* key : {"fixed_ms", "fixed_ns_per_px", "share_of_full_frame"})
        state.counters[key] = row[key].get<double>();
    state.counters["share_of_triad"] = bytes["share_of_triad"].get<double>();
    state.SetLabel(subject.note);
    bench.results.add("fixed_work", fmt::format("{}/{}", scene, scale.name), row);
}

}  // namespace

void register_fixed_work(Bench& bench) {
    for (const std::string& scene : scene_names()) {
        for (const Scale& scale : kScales) {
            benchmark::RegisterBenchmark(
                fmt::format("BM_FixedWork/{}/{}", scene, scale.name).c_str(),
                [&bench, scene, scale](benchmark::State& state) {
                    run(state, bench, scene, scale);
                })
                ->Iterations(kFrames)
                ->UseManualTime()
                ->Unit(benchmark::kMillisecond);
        }
    }
}

}  // namespace foverig::bench
