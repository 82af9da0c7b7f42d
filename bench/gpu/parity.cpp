#include <cmath>
#include <mutex>

#include "bench/agreement.h"
#include "bench/gpu/in_threads.h"
#include "bench/gpu/suites.h"
#include "bench/ray_kinds.h"
#include "renderer/backends/cuda/cuda_tracer.h"
#include "renderer/backends/host_bvh/host_backend.h"
#include "renderer/pipelines/cuda/cuda_full.h"
#include "renderer/pipelines/full_frame.h"

namespace foverig::gpu {
namespace {

constexpr float kPixelApart = 0.01F;

std::vector<Ray> rays_of(const Scene& scene, bench::RayKind kind, std::uint32_t count) {
    std::vector<Ray> rays(count);
    const bench::RayMaker make_ray(scene);
    in_threads(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            rays[i] = make_ray(kind, static_cast<std::uint32_t>(i));
    });
    return rays;
}

bool same_bits(const Hit& a, const Hit& b) {
    return a.triangle == b.triangle && (a.missed() || (a.t == b.t && a.u == b.u && a.v == b.v));
}

Json compare_kind(const GpuScene& scene, cuda::CudaTracer& tracer, bench::RayKind kind,
                  std::uint32_t count, std::uint64_t& wrong) {
    const std::vector<Ray> rays = rays_of(scene.scene(), kind, count);
    const std::vector<Hit> hits = tracer.closest(view_of(rays)).hits;
    const std::vector<float> visible = tracer.visible(view_of(rays)).visible;
    bench::Verdicts verdicts{};
    std::uint64_t exact = 0;
    std::mutex mutex;
    in_threads(rays.size(), [&](std::size_t begin, std::size_t end) {
        bench::Verdicts mine{};
        std::uint64_t mine_exact = 0;
        for (std::size_t i = begin; i < end; ++i) {
            const Hit host = scene.host().closest(rays[i]);
            const bool both_ask_alike = hits[i].missed() == (visible[i] > 0.0F);
            mine_exact += same_bits(hits[i], host) ? 1U : 0U;
            const bench::Verdict verdict =
                both_ask_alike ? bench::compare(scene.host().view(), rays[i], host, hits[i])
                               : bench::Verdict::wrong;
            ++mine[static_cast<std::size_t>(verdict)];
        }
        const std::lock_guard lock(mutex);
        exact += mine_exact;
        for (std::size_t v = 0; v < verdicts.size(); ++v) verdicts[v] += mine[v];
    });
    wrong += verdicts[static_cast<std::size_t>(bench::Verdict::wrong)];
    Json row = {{"same_bits", exact}};
    for (std::size_t v = 0; v < verdicts.size(); ++v) row[bench::kVerdictNames[v]] = verdicts[v];
    return row;
}

/// Every kind of light at once, small enough for one thread of the host.
Json compare_images(const GpuScene& scene, const Tolerances& tolerances, bool& pass) {
    RenderSettings settings;
    settings.pipeline = "full";
    settings.lighting.area_samples = 4;
    settings.lighting.ao_samples = 4;
    const EyeView view = scene.view(253, 187);
    host_bvh::HostBackend backend(scene.host());
    FullFrame<host_bvh::HostBackend> frame(backend, scene.scene(), settings);
    frame.render(view, 1);
    const std::vector<Half4> host = frame.image();
    cuda::CudaFull full(scene.scene(), scene.host().view(), scene.host().bvh().view(),
                        scene.holes(), settings);
    full.render(view, 1);
    const std::vector<Half4> device = full.image();
    std::size_t apart = 0;
    double sum = 0.0;
    for (std::size_t i = 0; i < host.size(); ++i) {
        const vec3 d = glm::abs(vec3(unpack_half4(host[i])) - vec3(unpack_half4(device[i])));
        apart += d.x + d.y + d.z <= kPixelApart ? 0U : 1U;
        sum += double{d.x} + d.y + d.z;
    }
    const auto pixels = static_cast<double>(host.size());
    const double share = static_cast<double>(apart) / pixels;
    const double mean = sum / (3.0 * pixels);
    const NumericCounts numerics = full.numerics();
    const bool good = share <= tolerances.pixels_apart_share && mean <= tolerances.mean_apart &&
                      numerics.nan == 0 && numerics.inf == 0;
    pass = pass && good;
    return {{"width_px", view.width_px},   {"height_px", view.height_px},
            {"pixels_apart_share", share}, {"mean_apart", mean},
            {"nan", numerics.nan},         {"inf", numerics.inf},
            {"within_tolerances", good}};
}

}  // namespace

Json parity(const GpuScene& scene, const GpuSettings& settings, const Tolerances& tolerances) {
    std::uint64_t wrong = 0;
    Json hits = Json::object();
    {
        cuda::CudaTracer tracer(scene.host().view(), scene.host().bvh().view(), scene.holes());
        for (const bench::RayKind kind : bench::kRayKinds)
            hits[bench::name_of(kind)] =
                compare_kind(scene, tracer, kind, settings.parity_rays, wrong);
    }
    bool pass = wrong <= tolerances.wrong_hits;
    const Json image = compare_images(scene, tolerances, pass);
    return {{"pass", pass}, {"wrong_hits", wrong}, {"hits", hits}, {"full", image}};
}

}  // namespace foverig::gpu
