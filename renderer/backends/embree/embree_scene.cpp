#include "renderer/backends/embree/embree_scene.h"

#include <fmt/format.h>

#include <stdexcept>

#include "renderer/kernels/alpha_test.h"

namespace foverig::embree {
namespace {

/// Spatial splits pay for themselves up to here; above, build time and memory rule.
constexpr std::size_t kMostTrianglesForSplits = 2'000'000;

void on_error(void* /*user*/, RTCError code, const char* text) {
    throw std::runtime_error(fmt::format("Embree error {}: {}", static_cast<int>(code), text));
}

bool on_memory(void* user, ssize_t bytes, bool /*post*/) {
    static_cast<std::atomic<std::int64_t>*>(user)->fetch_add(bytes, std::memory_order_relaxed);
    return true;
}

/// Steps through transparent texels; called for each candidate hit of a masked part.
void alpha_filter(const RTCFilterFunctionNArguments* args) {
    const auto& part = *static_cast<const MaskedPart*>(args->geometryUserPtr);
    for (unsigned lane = 0; lane < args->N; ++lane) {
        if (args->valid[lane] == 0) continue;
        const std::uint32_t triangle =
            part.first_triangle + RTCHitN_primID(args->hit, args->N, lane);
        if (is_hole(*part.scene, triangle, RTCHitN_u(args->hit, args->N, lane),
                    RTCHitN_v(args->hit, args->N, lane)))
            args->valid[lane] = 0;
    }
}

}  // namespace

EmbreeScene::EmbreeScene(const Scene& scene, const EmbreeSettings& settings)
    : posed_(scene, {settings.textures, settings.motion}) {
    device_ = Device(rtcNewDevice(
        settings.threads > 0 ? fmt::format("threads={}", settings.threads).c_str() : nullptr));
    if (device_.get() == nullptr)
        throw std::runtime_error("Embree has no device for this processor");
    rtcSetDeviceErrorFunction(device_.get(), on_error, nullptr);
    rtcSetDeviceMemoryMonitorFunction(device_.get(), on_memory, &embree_bytes_);
    attach_parts(settings);
}

void EmbreeScene::attach_parts(const EmbreeSettings& settings) {
    const Scene& source = posed_.source();
    const SceneView& seen = posed_.view();
    scene_ = SceneHandle(rtcNewScene(device_.get()));
    const bool moves = !posed_.moving_parts().empty();
    const bool splits = source.triangles.size() <= kMostTrianglesForSplits && !moves;
    rtcSetSceneBuildQuality(scene_.get(),
                            splits ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM);
    rtcSetSceneFlags(scene_.get(),
                     static_cast<RTCSceneFlags>((settings.robust ? RTC_SCENE_FLAG_ROBUST : 0) |
                                                (moves ? RTC_SCENE_FLAG_DYNAMIC : 0)));
    for (const Part& part : source.parts) {
        auto held = std::make_unique<PartGeometry>();
        held->masked = {&seen, part.first_triangle};
        held->geometry = Geometry(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
        const RTCGeometry g = held->geometry.get();
        if (moves && part.motion >= 0) rtcSetGeometryBuildQuality(g, RTC_BUILD_QUALITY_REFIT);
        rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                   seen.positions_m.data, 0, sizeof(vec3), seen.positions_m.size);
        rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                   source.triangles.data() + part.first_triangle, 0, sizeof(uvec3),
                                   part.triangle_count);
        if (part.alpha_masked && settings.alpha_test) {
            rtcSetGeometryUserData(g, &held->masked);
            rtcSetGeometryIntersectFilterFunction(g, alpha_filter);
            rtcSetGeometryOccludedFilterFunction(g, alpha_filter);
        }
        rtcCommitGeometry(g);
        rtcAttachGeometryByID(scene_.get(), g, static_cast<unsigned>(parts_.size()));
        first_triangles_.push_back(part.first_triangle);
        parts_.push_back(std::move(held));
    }
    rtcCommitScene(scene_.get());
}

void EmbreeScene::set_time(double time_s) {
    if (posed_.moving_parts().empty()) return;
    posed_.set_time(time_s);
    for (const std::size_t i : posed_.moving_parts()) {
        rtcUpdateGeometryBuffer(parts_[i]->geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0);
        rtcCommitGeometry(parts_[i]->geometry.get());
    }
    rtcCommitScene(scene_.get());
}

SceneBytes EmbreeScene::bytes() const {
    SceneBytes bytes = posed_.bytes();
    bytes.base += static_cast<std::uint64_t>(embree_bytes_.load(std::memory_order_relaxed)) +
                  first_triangles_.capacity() * sizeof(std::uint32_t) +
                  parts_.size() * sizeof(PartGeometry);
    return bytes;
}

}  // namespace foverig::embree
