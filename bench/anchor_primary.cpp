#include <array>

#include "bench/anchor.h"

namespace foverig::bench {
namespace {

void make_packet(const CameraRays& rays, int base, RTCRayHit16& packet) {
#pragma GCC ivdep
    for (int lane = 0; lane < 16; ++lane) {
        const Ray ray = rays(base + lane);
        packet.ray.org_x[lane] = ray.origin_m.x;
        packet.ray.org_y[lane] = ray.origin_m.y;
        packet.ray.org_z[lane] = ray.origin_m.z;
        packet.ray.dir_x[lane] = ray.direction.x;
        packet.ray.dir_y[lane] = ray.direction.y;
        packet.ray.dir_z[lane] = ray.direction.z;
        packet.ray.tnear[lane] = 0.0F;
        packet.ray.tfar[lane] = ray.t_max;
        packet.ray.time[lane] = 0.0F;
        packet.ray.mask[lane] = ~0U;
        packet.ray.id[lane] = 0U;
        packet.ray.flags[lane] = 0U;
        packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
        packet.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
    }
}

void keep(const RTCRayHit16& packet, int base, PrimaryAnswers& answers) {
    for (int lane = 0; lane < 16; ++lane) {
        const auto at = static_cast<std::size_t>(base + lane);
        answers.t[at] = packet.ray.tfar[lane];
        answers.geometry[at] = packet.hit.geomID[lane];
        answers.primitive[at] = packet.hit.primID[lane];
    }
}

/// Packets that a queue fills; the last one's spare lanes repeat its last pixel and count for
/// nothing.
CameraRays rays_of(const PixelQueue& queue) {
    return {queue.eye, View<const PackedPixel>{queue.pixels.data(), queue.pixels.size()},
            vec2(0.0F)};
}

void packets(RTCScene scene, const PixelQueue& queue, PrimaryAnswers& answers) {
    const CameraRays rays = rays_of(queue);
    embree::Query query(embree::Coherence::coherent);
    alignas(64) std::array<int, 16> valid;
    valid.fill(-1);
    for (int base = 0; base < queue.count; base += 16) {
        RTCRayHit16 packet;
        make_packet(rays, base, packet);
        query.closest16(valid.data(), scene, packet);
        keep(packet, base, answers);
    }
}

#if RTC_VERSION_MAJOR < 4
/// Streams of four packets.
void stream_of_packets(RTCScene scene, const PixelQueue& queue, PrimaryAnswers& answers) {
    constexpr int kPackets = 4;
    const CameraRays rays = rays_of(queue);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    std::array<RTCRayHit16, kPackets> stream;
    for (int base = 0; base < queue.count; base += 16 * kPackets) {
        const int left = (queue.count - base + 15) / 16;
        const int packets_here = left < kPackets ? left : kPackets;
        for (int p = 0; p < packets_here; ++p)
            make_packet(rays, base + 16 * p, stream[static_cast<std::size_t>(p)]);
        rtcIntersectNM(scene, &context, reinterpret_cast<RTCRayHitN*>(stream.data()), 16,
                       static_cast<unsigned>(packets_here), sizeof(RTCRayHit16));
        for (int p = 0; p < packets_here; ++p)
            keep(stream[static_cast<std::size_t>(p)], base + 16 * p, answers);
    }
}
#endif

}  // namespace

std::span<const PrimaryAnchor> primary_anchors() {
    static constexpr PrimaryAnchor kAnchors[] = {
        {"intersect16_coherent", packets},
#if RTC_VERSION_MAJOR < 4
        {"intersectNM_16x4_coherent", stream_of_packets},
#endif
    };
    return kAnchors;
}

}  // namespace foverig::bench
