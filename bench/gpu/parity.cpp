#include <cmath>
#include <mutex>

#include "bench/agreement.h"
#include "bench/gpu/in_threads.h"
#include "bench/gpu/suites.h"
#include "bench/ray_kinds.h"
#include "renderer/backends/cuda/cuda_tracer.h"

namespace foverig::gpu {
namespace {

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
    const Json frames = frame_parity(scene, tolerances);
    const bool pass = wrong <= tolerances.wrong_hits && frames["pass"].get<bool>();
    return {{"pass", pass},
            {"may_be_timed", wrong <= tolerances.wrong_hits && frames["sound"].get<bool>()},
            {"wrong_hits", wrong},
            {"hits", hits},
            {"frames", frames}};
}

}  // namespace foverig::gpu
