// Frames begun at each VSync of a wall clock: how many are late, and how steady they are.
#include <chrono>
#include <thread>

#include "bench/gpu/gpu_flight.h"
#include "bench/gpu/suites.h"
#include "renderer/pipelines/cuda/cuda_renderer.h"

namespace foverig::gpu {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kFrame = std::chrono::nanoseconds(13'333'333);
constexpr auto kSpin = std::chrono::microseconds(300);  // a sleep's lateness
constexpr int kWarmUpFrames = 75;

double percentile(std::vector<double>& sorted, double p) {
    const auto last = static_cast<double>(sorted.size() - 1);
    return sorted[static_cast<std::size_t>(std::lround(p * last))];
}

}  // namespace

Json pacing(const GpuScene& scene, int count) {
    RenderSettings settings;
    settings.lighting.area_lights = false;
    settings.lighting.ao_samples = 16;
    const auto renderer =
        cuda::make_cuda_renderer(shared(scene), settings, {1, true, scene.build()});
    std::vector<double> ms;
    int missed = 0;
    Clock::time_point vsync = Clock::now() + kFrame;
    for (int frame = 0; frame < kWarmUpFrames + count; ++frame) {
        std::this_thread::sleep_until(vsync - kSpin);
        while (Clock::now() < vsync) {
        }
        renderer->render(flight(scene, frame, kMostEyes, kDk2Eye));
        const Clock::time_point end = Clock::now();
        if (frame >= kWarmUpFrames)
            ms.push_back(std::chrono::duration<double, std::milli>(end - vsync).count());
        vsync += kFrame;
        if (end <= vsync) continue;
        missed += frame >= kWarmUpFrames ? 1 : 0;
        while (vsync < end) vsync += kFrame;
    }
    std::sort(ms.begin(), ms.end());
    const double p50 = percentile(ms, 0.50);
    const double p99 = percentile(ms, 0.99);
    return {{"frames", count},         {"rate_hz", kRate_hz},
            {"missed_vsyncs", missed}, {"p50_ms", p50},
            {"p99_ms", p99},           {"p99_9_ms", percentile(ms, 0.999)},
            {"most_ms", ms.back()},    {"p99_over_p50", p99 / p50}};
}

}  // namespace foverig::gpu
