#include <algorithm>
#include <array>
#include <cstring>

#include "bench/anchor.h"

namespace foverig::bench {
namespace {

template <embree::Coherence kCoherence>
std::uint64_t packets(RTCScene scene, const RayList& rays) {
    embree::Query query(kCoherence);
    alignas(64) std::array<int, 16> valid;
    std::uint64_t occluded = 0;
    for (const RayBlock& block : rays.blocks()) {
        RTCRay16 packet;
        std::memcpy(packet.org_x, block.org_x, sizeof packet.org_x);
        std::memcpy(packet.org_y, block.org_y, sizeof packet.org_y);
        std::memcpy(packet.org_z, block.org_z, sizeof packet.org_z);
        std::memcpy(packet.dir_x, block.dir_x, sizeof packet.dir_x);
        std::memcpy(packet.dir_y, block.dir_y, sizeof packet.dir_y);
        std::memcpy(packet.dir_z, block.dir_z, sizeof packet.dir_z);
        std::memcpy(packet.tfar, block.t_max, sizeof packet.tfar);
        for (std::size_t lane = 0; lane < 16; ++lane) {
            packet.tnear[lane] = 0.0F;
            packet.time[lane] = 0.0F;
            packet.mask[lane] = ~0U;
            packet.flags[lane] = 0U;
            valid[lane] = block.t_max[lane] >= 0.0F ? -1 : 0;
        }
        int count = 0;
        query.occluded16(valid.data(), scene, packet);
        for (std::size_t lane = 0; lane < 16; ++lane)
            count += (valid[lane] != 0) & (packet.tfar[lane] < 0.0F) ? 1 : 0;
        occluded += static_cast<std::uint64_t>(count);
    }
    return occluded;
}

#if RTC_VERSION_MAJOR < 4
/// Streams of single rays, sixty-four blocks at a time.
std::uint64_t streams(RTCScene scene, const RayList& rays) {
    constexpr std::size_t kBlocks = 64;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    static thread_local std::array<RTCRay, kBlocks * 16> stream;
    const auto& blocks = rays.blocks();
    std::uint64_t occluded = 0;
    for (std::size_t first = 0; first < blocks.size(); first += kBlocks) {
        const std::size_t end = std::min(first + kBlocks, blocks.size());
        unsigned n = 0;
        for (std::size_t b = first; b < end; ++b) {
            for (std::size_t lane = 0; lane < 16; ++lane) {
                const RayBlock& block = blocks[b];
                RTCRay& ray = stream[n];
                ray.org_x = block.org_x[lane];
                ray.org_y = block.org_y[lane];
                ray.org_z = block.org_z[lane];
                ray.dir_x = block.dir_x[lane];
                ray.dir_y = block.dir_y[lane];
                ray.dir_z = block.dir_z[lane];
                ray.tnear = 0.0F;
                ray.tfar = block.t_max[lane];
                ray.time = 0.0F;
                ray.mask = ~0U;
                ray.flags = 0U;
                n += block.t_max[lane] >= 0.0F ? 1U : 0U;
            }
        }
        rtcOccluded1M(scene, &context, stream.data(), n, sizeof(RTCRay));
        for (unsigned i = 0; i < n; ++i) occluded += stream[i].tfar < 0.0F ? 1U : 0U;
    }
    return occluded;
}
#endif

}  // namespace

std::span<const OcclusionAnchor> occlusion_anchors() {
    static constexpr OcclusionAnchor kAnchors[] = {
        {"occluded16_coherent", packets<embree::Coherence::coherent>},
        {"occluded16_incoherent", packets<embree::Coherence::incoherent>},
#if RTC_VERSION_MAJOR < 4
        {"occluded1M_1024_coherent", streams},
#endif
    };
    return kAnchors;
}

}  // namespace foverig::bench
