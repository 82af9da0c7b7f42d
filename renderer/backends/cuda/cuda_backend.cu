#include "renderer/backends/cuda/cuda_backend.cuh"

#include <algorithm>

#include "renderer/backends/cuda/device_info.h"

namespace foverig::cuda {
namespace {

constexpr std::size_t kMostPasses = 4096;     ///< of one frame that trace
constexpr std::size_t kMostRays = 1U << 31U;  ///< of one queue

Stream stream_on(int device) {
    device_info(device);
    check(cudaSetDevice(device), "cudaSetDevice");
    return make_stream();
}

int multiprocessors() {
    int device = 0;
    int count = 0;
    check(cudaGetDevice(&device), "cudaGetDevice");
    check(cudaDeviceGetAttribute(&count, cudaDevAttrMultiProcessorCount, device),
          "cudaDeviceGetAttribute");
    return count;
}

}  // namespace

CudaBackend::CudaBackend(const SceneView& scene, const BvhView& bvh, bool holes)
    : stream_(stream_on(device_)),
      multiprocessors_(multiprocessors()),
      holes_(holes),
      scene_(memory_, scene, bvh, stream_.get()),
      counters_(memory_, kMostPasses),
      numbers_(memory_, kMostNumbers) {}

CudaBackend::CudaBackend(const host_bvh::HostBvhScene& scene, int device, bool graphs)
    : device_(device),
      graphs_(graphs),
      stream_(stream_on(device)),
      multiprocessors_(multiprocessors()),
      holes_(scene.holes()),
      scene_(memory_, scene.view(), scene.bvh().view(), stream_.get(), scene.bvh().plan()),
      counters_(memory_, kMostPasses),
      numbers_(memory_, kMostNumbers) {}

View<const Half4> CudaBackend::on_host(View<const Half4> image, int eye) {
    PinnedArray<Half4>& to = images_.at(static_cast<std::size_t>(eye));
    if (to.view().size != image.size) to = PinnedArray<Half4>(pinned_, image.size);
    copy_to_host(to.view().data, image);
    return to.view();
}

void CudaBackend::set_time(host_bvh::HostBvhScene& scene, double time_s) {
    if (!scene_.moves()) return;
    scene.move_vertices(time_s);
    scene_.stage(scene.view());
    moved_ = true;
}

std::vector<int> CudaBackend::take_numbers() {
    return download(View<const int>{numbers_.data(), numbers_used_});
}

int* CudaBackend::next_number() {
    if (numbers_used_ == kMostNumbers)
        throw CudaError("a frame has more than " + std::to_string(kMostNumbers) +
                        " queues of a length that is found on the device");
    return numbers_.data() + numbers_used_++;
}

int CudaBackend::resident_blocks(const void* kernel, std::size_t rays) {
    if (rays >= kMostRays)
        throw CudaError("a queue of " + std::to_string(rays) +
                        " rays is too long; at most 2^31 - 1");
    const auto [at, added] = blocks_per_multiprocessor_.try_emplace(kernel, 0);
    if (added) {
        check(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&at->second, kernel, kThreads, 0),
              "cudaOccupancyMaxActiveBlocksPerMultiprocessor");
        at->second = std::max(at->second, 1);
    }
    const std::size_t full = static_cast<std::size_t>(at->second * multiprocessors_);
    return static_cast<int>(std::min(full, (rays + kThreads - 1) / kThreads));
}

int CudaBackend::next_counter() {
    if (static_cast<std::size_t>(counters_used_) == kMostPasses)
        throw CudaError("a frame has more than " + std::to_string(kMostPasses) + " tracing passes");
    return counters_used_++;
}

PassTable CudaBackend::take_passes() {
    const auto used = static_cast<std::size_t>(counters_used_);
    const auto counted = download(View<const QueueCounter>{counters_.data(), used});
    PassTable table;
    for (const PassClock::Pass& pass : clock_.take())
        table.add(pass.name, pass.ns,
                  pass.counter < 0 ? 0 : counted[static_cast<std::size_t>(pass.counter)].traced);
    check(cudaMemsetAsync(counters_.data(), 0, used * sizeof(QueueCounter), stream_.get()),
          "cudaMemsetAsync of the counters");
    counters_used_ = 0;
    return table;
}

}  // namespace foverig::cuda
