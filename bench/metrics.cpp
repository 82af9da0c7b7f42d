// Each metric between two images of a DK2's eye (1182 x 1464) on one thread and on all. First the
// rows of ../shared/metrics/expected.json must come out right; where that folder is absent, what
// they are between black and white, which is known by hand.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>

#include "bench/statistics.h"
#include "bench/suites.h"
#include "metrics/change.h"
#include "metrics/display_code.h"
#include "metrics/eccentricity.h"
#include "metrics/flicker.h"
#include "metrics/flip.h"
#include "metrics/flip_hdr.h"
#include "metrics/fovvideovdp.h"
#include "metrics/pixel_errors.h"
#include "metrics/pooling.h"
#include "metrics/ssim.h"
#include "renderer/image_read.h"

namespace foverig::bench {
namespace {

namespace fs = std::filesystem;
using namespace metrics;

constexpr int kWidth_px = 1182, kHeight_px = 1464;
constexpr double kDk2PixelsPerDegree = 9.59;
constexpr int kTimes = 5;

/// Rings with a fine pattern, and the same with an error everywhere, so that no branch is spared.
Image picture(float error) {
    Image image{kWidth_px, kHeight_px, {}};
    for (int y = 0; y < kHeight_px; ++y)
        for (int x = 0; x < kWidth_px; ++x) {
            const float radius = std::hypot(static_cast<float>(x - 500), static_cast<float>(y));
            const float wave = 0.5F + 0.4F * std::sin(0.002F * radius * radius);
            const float grain = error * std::sin(static_cast<float>(x * 7919 + y * 104729));
            image.pixels.emplace_back(wave + grain, wave * wave + grain, 1.0F - wave - grain);
        }
    return image;
}

/// The screen that a row of FovVideoVDP was computed for.
ScreenLight light_of(const nlohmann::json& row) {
    if (row.at("display") != "standard_4k") return {};
    return {200.0, 0.2 + 250.0 / std::numbers::pi * 0.005};  // 250 lux, of which 0.5 % come back
}

/// A still, seen as its row says.
double jod_of(const nlohmann::json& row, const Image& r, const Image& t) {
    const auto at = row.value("fixation", std::vector<double>{0.0, 0.0});
    FovVideoVdp vdp(light_of(row), std::nullopt);
    vdp.add(r, t, gazed_screen(r.width_px, r.height_px, row.at("ppd"), at[0], at[1]),
            row.at("foveated"));
    return vdp.jod();
}

/// How many rows were found right; throws with the first that is not.
int prove_rows(const fs::path& folder) {
    const auto json = nlohmann::json::parse(std::ifstream(folder / "expected.json"));
    int rows = 0;
    const auto expect = [&](const nlohmann::json& row, double got, const char* key, double within) {
        const double expected = row.at(key).get<double>();
        if (!(std::abs(got - expected) <= within))
            throw std::runtime_error(fmt::format("{} of {} and {} is {} and not {}", key,
                                                 row.at("ref").dump(), row.at("test").dump(), got,
                                                 expected));
        ++rows;
    };
    const auto image = [&](const nlohmann::json& row, const char* key) {
        return read_image(folder / row.at(key).get<std::string>()).image;
    };
    for (const auto& row : json.at("flip")) {
        const Image r = image(row, "ref");
        const Image t = image(row, "test");
        const double ppd = row.at("ppd");
        if (row.at("mode") == "LDR") {
            expect(row, pool(flip(r, t, ppd)).mean, "mean", 2.0e-4);
        } else if (row.at("tone_mapper") == "aces" && !row.contains("exposures_forced")) {
            const auto range = exposure_range(r, ToneMapper::aces);
            expect(row, pool(flip_hdr(r, t, ppd, ToneMapper::aces, range)).mean, "mean", 2.0e-4);
        }
    }
    for (const auto& row : json.at("fvvdp"))
        if (row.at("metric") == "fvvdp" && row.contains("ppd"))
            expect(row, jod_of(row, image(row, "ref"), image(row, "test")), "jod", 5.0e-3);
    for (const auto& row : json.at("basic")) {
        const Image r = image(row, "ref");
        const Image t = image(row, "test");
        if (row.contains("psnr_rgb8"))
            expect(row, psnr_db(code_differences(r, t).mse), "psnr_rgb8", 1.0e-3);
        if (row.contains("ssim_luma_wang2004"))
            expect(row, ssim(r, t).value_or(-1.0), "ssim_luma_wang2004", 2.0e-4);
        if (row.contains("relmse_eps1e_2"))
            expect(row, relative_differences(r, t).relmse, "relmse_eps1e_2", 1.0e-6);
    }
    return rows;
}

void prove_by_hand() {
    const Image black{32, 32, std::vector<vec3>(32 * 32, vec3(0.0F))};
    const Image white{32, 32, std::vector<vec3>(32 * 32, vec3(1.0F))};
    if (std::abs(pool(flip(black, white, 30.0)).mean - 0.96738) > 1.0e-4 ||
        std::abs(code_differences(black, white).mse - 65025.0) > 0.1)
        throw std::runtime_error("black and white are not as far apart as they are by hand");
}

struct Metric {
    const char* name;
    std::function<void(const Image&, const Image&)> run;
};

std::vector<Metric> timed_metrics() {
    const GazedView view = gazed_screen(kWidth_px, kHeight_px, kDk2PixelsPerDegree, 600.0, 700.0);
    return {
        {"flip/ppd:67", [](const Image& a, const Image& b) { pool(flip(a, b, 67.0206)); }},
        {"flip/ppd:9.59",
         [](const Image& a, const Image& b) { pool(flip(a, b, kDk2PixelsPerDegree)); }},
        {"flip_hdr/ppd:67/exposures:14",
         [](const Image& a, const Image& b) {
             pool(flip_hdr(a, b, 67.0206, ToneMapper::aces, {-10.0, 3.0, 14}));
         }},
        {"ssim", [](const Image& a, const Image& b) { benchmark::DoNotOptimize(ssim(a, b)); }},
        {"mse_mae_psnr",
         [](const Image& a, const Image& b) {
             benchmark::DoNotOptimize(psnr_db(code_differences(a, b).mse));
         }},
        {"relmse_smape",
         [](const Image& a, const Image& b) {
             benchmark::DoNotOptimize(relative_differences(a, b));
         }},
        {"gaze",
         [view](const Image& a, const Image& b) {
             benchmark::DoNotOptimize(pool_by_gaze(absolute_error(a, b), view, 10.0));
         }},
        {"change/frames:2",
         [](const Image& a, const Image& b) {
             ChangeOverTime change;
             change.add(a, b);
             change.add(b, a);
             benchmark::DoNotOptimize(change.change());
         }},
        {"fvvdp/foveated/still",
         [view](const Image& a, const Image& b) {
             FovVideoVdp vdp({}, std::nullopt);
             vdp.add(a, b, view, true);
             benchmark::DoNotOptimize(vdp.jod());
         }},
        {"fvvdp/foveated/frames:2",
         [view](const Image& a, const Image& b) {
             FovVideoVdp vdp({}, 75.0);
             vdp.add(a, b, view, true);
             vdp.add(b, a, view, true);
             benchmark::DoNotOptimize(vdp.jod());
         }},
        {"flicker/frames:2",
         [](const Image& a, const Image& b) {
             Flicker flicker(75.0);
             flicker.add(a, b);
             flicker.add(b, a);
             benchmark::DoNotOptimize(flicker.rms_codes());
         }},
    };
}

void run(benchmark::State& state, Bench& bench, const Metric& metric, int threads) {
    static const Image reference = picture(0.0F);
    static const Image test = picture(0.05F);
    static const fs::path folder = bench.options.scenes.parent_path() / "metrics";
    static const int proven = [] {
        prove_by_hand();
        return fs::exists(folder / "expected.json") ? prove_rows(folder) : 0;
    }();
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    std::vector<double> times_ms;
    for (auto unused : state) {
        const auto begin = std::chrono::steady_clock::now();
        metric.run(reference, test);
        const std::chrono::duration<double, std::milli> time =
            std::chrono::steady_clock::now() - begin;
        times_ms.push_back(time.count());
    }
    state.counters["proven_rows"] = proven;
    bench.results.add("metrics", fmt::format("{}/threads:{}", metric.name, threads),
                      {{"width_px", kWidth_px},
                       {"height_px", kHeight_px},
                       {"threads", threads},
                       {"median_ms", median(times_ms)},
                       {"best_ms", *std::min_element(times_ms.begin(), times_ms.end())},
                       {"times", times_ms.size()},
                       {"proven_rows", proven}});
}

}  // namespace

void register_metrics(Bench& bench) {
    const int all = tbb::info::default_concurrency();
    for (const Metric& metric : timed_metrics())
        for (const int threads : all > 1 ? std::vector{1, all} : std::vector{1})
            benchmark::RegisterBenchmark(
                fmt::format("BM_Metrics/{}/threads:{}", metric.name, threads).c_str(),
                [&bench, metric, threads](benchmark::State& state) {
                    try {
                        run(state, bench, metric, threads);
                    } catch (const std::exception& error) {
                        state.SkipWithError(error.what());
                    }
                })
                ->Iterations(kTimes)
                ->UseRealTime()
                ->Unit(benchmark::kMillisecond);
}

}  // namespace foverig::bench
