#include <map>

#include "bench/gpu/suites.h"
#include "bench/statistics.h"
#include "renderer/pipelines/cuda/cuda_full.h"

namespace foverig::gpu {
namespace {

constexpr int kWidth_px = 1182;  // Weier 2016: one eye of the DK2
constexpr int kHeight_px = 1464;
constexpr int kWarmUpFrames = 3;

Json frames_of(const GpuScene& scene, const LightingSettings& lighting, int repetitions) {
    RenderSettings settings;
    settings.pipeline = "full";
    settings.lighting = lighting;
    cuda::CudaFull full(scene.scene(), scene.host().view(), scene.host().bvh().view(),
                        scene.holes(), settings);
    const EyeView view = scene.view(kWidth_px, kHeight_px);
    std::map<std::string, std::vector<double>> pass_ms;
    std::vector<double> frame_ms;
    std::uint64_t rays = 0;
    for (int frame = 0; frame < kWarmUpFrames + repetitions; ++frame) {
        const PassTable passes = full.render(view, static_cast<std::uint32_t>(frame));
        if (frame < kWarmUpFrames) continue;
        double sum_ms = 0.0;
        rays = 0;
        for (const PassTable::Entry& pass : passes.entries()) {
            const double ms = static_cast<double>(pass.ns) * 1e-6;
            pass_ms[std::string(pass.name)].push_back(ms);
            sum_ms += ms;
            rays += pass.rays;
        }
        frame_ms.push_back(sum_ms);
    }
    Json passes = Json::object();
    for (const auto& [name, ms] : pass_ms) passes[name] = bench::median(ms);
    return {{"passes_sum_ms", bench::median(frame_ms)},
            {"rays", rays},
            {"pass_ms", passes},
            {"nan", full.numerics().nan}};
}

}  // namespace

Json full_frames(const GpuScene& scene, const GpuSettings& settings) {
    LightingSettings point;
    point.area_lights = false;
    LightingSettings area;
    area.point_lights = false;
    area.area_samples = 8;
    LightingSettings occlusion;
    occlusion.point_lights = occlusion.area_lights = false;
    occlusion.ao_samples = 16;
    return {{"width_px", kWidth_px},
            {"height_px", kHeight_px},
            {"point", frames_of(scene, point, settings.repetitions)},
            {"area8", frames_of(scene, area, settings.repetitions)},
            {"ao16", frames_of(scene, occlusion, settings.repetitions)}};
}

}  // namespace foverig::gpu
