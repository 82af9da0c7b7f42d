// Table 1 of Weier 2016 on the GPU: light x pipeline x eyes, frame and pass times.
#include <map>

#include "bench/gpu/gpu_flight.h"
#include "bench/gpu/suites.h"
#include "bench/statistics.h"
#include "renderer/pipelines/cuda/cuda_renderer.h"

namespace foverig::gpu {
namespace {

constexpr int kWarmUpFrames = 5;  // two without a history or a graph, and the clock's rise
constexpr int kFramesPerRepetition = 4;

Json flown(const GpuScene& scene, Renderer& renderer, int eyes, const EyeSize& size,
           int repetitions) {
    std::map<std::string, std::vector<double>> pass_ms;
    std::vector<double> device_ms;
    std::vector<double> wall_ms;
    FrameStats stats;
    for (int frame = 0; frame < kWarmUpFrames + repetitions * kFramesPerRepetition; ++frame) {
        stats = renderer.render(flight(scene, frame, eyes, size));
        if (frame < kWarmUpFrames) continue;
        std::map<std::string, double> sums;
        double all = 0.0;
        for (const PassTime& pass : stats.passes) {
            sums[pass.name] += pass.ms;
            all += pass.ms;
        }
        for (const auto& [name, ms] : sums) pass_ms[name].push_back(ms);
        device_ms.push_back(all);
        wall_ms.push_back(stats.render_ms);
    }
    Json passes = Json::object();
    for (const auto& [name, ms] : pass_ms) passes[name] = bench::median(ms);
    return {{"passes_sum_ms", bench::median(device_ms)},
            {"wall_ms", bench::median(wall_ms)},
            {"wall_ms_most", bench::largest(wall_ms)},
            {"sampled_share",
             static_cast<double>(stats.sampled_pixels) / static_cast<double>(stats.all_pixels)},
            {"rays", stats.rays.total()},
            {"backend_bytes", renderer.backend_bytes()},
            {"pass_ms", passes}};
}

struct Light {
    const char* name;
    LightingSettings settings;
};

std::vector<Light> table_1() {
    Light point{"point", {}};
    point.settings.area_lights = false;
    Light area{"area8", {}};
    area.settings.point_lights = false;
    area.settings.area_samples = 8;
    Light occlusion{"ao16", {}};
    occlusion.settings.point_lights = occlusion.settings.area_lights = false;
    occlusion.settings.ao_samples = 16;
    return {point, area, occlusion};
}

}  // namespace

Json frames(const GpuScene& scene, const GpuSettings& settings) {
    Json rows = Json::object();
    for (const Light& light : table_1()) {
        for (const char* pipeline : {"full", "reprojected"}) {
            RenderSettings render;
            render.pipeline = pipeline;
            render.lighting = light.settings;
            Json row = Json::object();
            for (const bool graphs : {true, false}) {
                const auto renderer =
                    cuda::make_cuda_renderer(shared(scene), render, {1, graphs, scene.build()});
                const char* both = graphs ? "both_eyes" : "both_eyes_without_graph";
                row[both] = flown(scene, *renderer, 2, kDk2Eye, settings.repetitions);
                if (!graphs) continue;
                row["one_eye"] = flown(scene, *renderer, 1, kDk2Eye, settings.repetitions);
                row["both_eyes_4k"] = flown(scene, *renderer, 2, kEye4k, settings.repetitions);
            }
            rows[light.name][pipeline] = row;
        }
    }
    return rows;
}

}  // namespace foverig::gpu
