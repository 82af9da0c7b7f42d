#include "renderer/backends/cuda/cuda_tracer.h"

#include "renderer/backends/cuda/cuda_backend.cuh"
#include "renderer/kernels/camera_rays.h"

namespace foverig::cuda {
namespace {

struct GivenRays {
    View<const Ray> rays;
    RIG_HD Ray operator()(int i) const { return rays[static_cast<std::size_t>(i)]; }
};

struct GivenShadowRays {
    View<const Ray> rays;
    RIG_HD WeightedRay operator()(int slot, int /*sample*/) const {
        return {rays[static_cast<std::size_t>(slot)], 1.0F};
    }
};

struct StoreShare {
    View<float> visible;
    template <class Shares>
    RIG_HD void operator()(int slot, const Shares& shares) const {
        visible[static_cast<std::size_t>(slot)] = shares(0);
    }
};

/// Of each repetition; the first waits for the rays' upload and warms up, so it is not kept.
template <class Trace>
std::vector<double> times_ms(CudaBackend& backend, int repetitions, const Trace& trace) {
    std::vector<double> ms;
    for (int i = -1; i < repetitions; ++i) {
        trace();
        const PassTable passes = backend.take_passes();
        for (const PassTable::Entry& pass : passes.entries())
            if (i >= 0) ms.push_back(static_cast<double>(pass.ns) * 1e-6);
    }
    return ms;
}

}  // namespace

CudaTracer::CudaTracer(const SceneView& scene, const BvhView& bvh, bool holes)
    : backend_(std::make_unique<CudaBackend>(scene, bvh, holes)) {}

CudaTracer::~CudaTracer() = default;

TracedHits CudaTracer::closest(View<const Ray> rays, int repetitions) {
    MemoryCount count;
    DeviceArray<Ray> on_device(count, rays.size);
    DeviceArray<Hit> hits(count, rays.size);
    backend_->upload(on_device, rays);
    const QueueSize size{static_cast<int>(rays.size)};
    std::vector<double> ms = times_ms(*backend_, repetitions, [&] {
        backend_->closest("trace_closest", size, GivenRays{on_device.view()},
                          StoreHit{hits.view()});
    });
    return {backend_->download(hits), std::move(ms)};
}

TracedShadows CudaTracer::visible(View<const Ray> rays, int repetitions) {
    MemoryCount count;
    DeviceArray<Ray> on_device(count, rays.size);
    DeviceArray<float> visible(count, rays.size);
    backend_->upload(on_device, rays);
    const QueueSize size{static_cast<int>(rays.size)};
    std::vector<double> ms = times_ms(*backend_, repetitions, [&] {
        backend_->visible("trace_visible", size, 1, GivenShadowRays{on_device.view()},
                          StoreShare{visible.view()});
    });
    return {backend_->download(visible), std::move(ms)};
}

std::uint64_t CudaTracer::scene_bytes() const {
    return backend_->bytes();
}

}  // namespace foverig::cuda
