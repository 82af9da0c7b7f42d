// Whole pipelines on the GPU against their twins on the host, and graphs against single launches.
#include "bench/gpu/gpu_flight.h"
#include "bench/gpu/suites.h"
#include "renderer/backends/host_bvh/host_backend.h"
#include "renderer/pipelines/cuda/cuda_renderer.h"
#include "renderer/pipelines/frame/frame_renderer.h"

namespace foverig::gpu {
namespace {

constexpr EyeSize kSmall{253, 187};  // one thread of the host renders the twin
constexpr float kPixelApart = 0.01F;
constexpr int kFrames = 5;  // the third is the first that can be a graph

struct Apart {
    std::size_t pixels = 0;
    std::size_t apart = 0;
    double sum = 0.0;

    void add(const Image& a, const Image& b) {
        for (std::size_t i = 0; i < a.pixels.size(); ++i) {
            const vec3 d = glm::abs(a.pixels[i] - b.pixels[i]);
            apart += d.x + d.y + d.z <= kPixelApart ? 0U : 1U;
            sum += double{d.x} + d.y + d.z;
        }
        pixels += a.pixels.size();
    }
    double share() const { return static_cast<double>(apart) / static_cast<double>(pixels); }
    double mean() const { return sum / (3.0 * static_cast<double>(pixels)); }
};

std::unique_ptr<Renderer> on_gpu(const GpuScene& scene, const RenderSettings& settings,
                                 bool graphs) {
    return cuda::make_cuda_renderer(shared(scene), settings, {1, graphs, scene.build()});
}

template <template <class> class Pipeline>
Json compare(const GpuScene& scene, const RenderSettings& settings, const Tolerances& tolerances,
             bool& pass, bool& sound) {
    FrameRenderer<host_bvh::HostBackend, Pipeline> host(shared(scene), settings, scene.build());
    const auto device = on_gpu(scene, settings, false);
    const auto graphs = on_gpu(scene, settings, true);
    Apart apart;
    std::size_t graph_pixels_apart = 0;
    NumericCounts numerics;
    for (int frame = 0; frame < kFrames; ++frame) {
        const FrameInput input = flight(scene, frame, kMostEyes, kSmall);
        host.render(input);
        const FrameStats stats = device->render(input);
        graphs->render(input);
        numerics.nan += stats.numerics.nan;
        numerics.inf += stats.numerics.inf;
        for (int eye = 0; eye < kMostEyes; ++eye) {
            const Image image = device->image(eye);
            apart.add(host.image(eye), image);
            const Image by_graph = graphs->image(eye);
            for (std::size_t i = 0; i < image.pixels.size(); ++i)
                graph_pixels_apart += image.pixels[i] != by_graph.pixels[i];
        }
    }
    const bool whole = numerics.nan == 0 && numerics.inf == 0 && graph_pixels_apart == 0;
    const bool good = whole && apart.share() <= tolerances.pixels_apart_share &&
                      apart.mean() <= tolerances.mean_apart;
    sound = sound && whole;
    pass = pass && good;
    return {{"width_px", kSmall.width_px},
            {"height_px", kSmall.height_px},
            {"frames", kFrames},
            {"eyes", kMostEyes},
            {"pixels_apart_share", apart.share()},
            {"mean_apart", apart.mean()},
            {"graph_pixels_apart", graph_pixels_apart},
            {"nan", numerics.nan},
            {"inf", numerics.inf},
            {"within_tolerances", good}};
}

}  // namespace

Json frame_parity(const GpuScene& scene, const Tolerances& tolerances) {
    RenderSettings settings;
    settings.lighting.area_samples = 4;
    settings.lighting.ao_samples = 4;
    bool pass = true;
    bool sound = true;
    settings.pipeline = "full";
    const Json full = compare<FullFrame>(scene, settings, tolerances, pass, sound);
    settings.pipeline = "reprojected";
    const Json reprojected = compare<ReprojectedFrame>(scene, settings, tolerances, pass, sound);
    return {{"pass", pass}, {"sound", sound}, {"full", full}, {"reprojected", reprojected}};
}

}  // namespace foverig::gpu
