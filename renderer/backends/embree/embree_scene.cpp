#include "renderer/backends/embree/embree_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
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

quat turn_of(const Motion& motion, double time_s) {
    const double angle_rad =
        std::remainder(static_cast<double>(motion.rate_rad_s) * time_s, 2.0 * std::numbers::pi);
    return glm::angleAxis(static_cast<float>(angle_rad), glm::normalize(motion.axis));
}

vec3 shift_of(const Motion& motion, double time_s) {
    return motion.swing_m *
           static_cast<float>(
               std::sin(2.0 * std::numbers::pi * static_cast<double>(motion.swing_hz) * time_s));
}

}  // namespace

EmbreeScene::EmbreeScene(const Scene& scene, const EmbreeSettings& settings) : source_(scene) {
    positions_m_.reserve(scene.positions_m.size() + 2);
    positions_m_ = scene.positions_m;
    if (settings.textures && !scene.textures.empty() && !scene.texcoords.empty()) {
        build_texel_density();
        build_textures();
    }
    const Scene& s = scene;
    view_ = {view_of(std::as_const(positions_m_)),
             view_of(s.normals),
             view_of(s.texcoords),
             view_of(s.triangles),
             view_of(s.triangle_materials),
             view_of(std::as_const(texel_density_log2_)),
             view_of(s.materials),
             view_of(s.textures),
             view_of(s.texels),
             view_of(std::as_const(linear_texels_)),
             view_of(std::as_const(mips_)),
             view_of(s.point_lights),
             view_of(s.area_lights),
             s.ambient,
             s.background};
    device_ = Device(rtcNewDevice(
        settings.threads > 0 ? fmt::format("threads={}", settings.threads).c_str() : nullptr));
    if (device_.get() == nullptr)
        throw std::runtime_error("Embree has no device for this processor");
    rtcSetDeviceErrorFunction(device_.get(), on_error, nullptr);
    rtcSetDeviceMemoryMonitorFunction(device_.get(), on_memory, &embree_bytes_);
    attach_parts(settings);
}

void EmbreeScene::build_texel_density() {
    const Scene& s = source_;
    texel_density_log2_.resize(s.triangles.size());
    for (std::size_t i = 0; i < s.triangles.size(); ++i) {
        const Material& m = s.materials[s.triangle_materials[i]];
        const std::int32_t texture =
            m.diffuse_texture >= 0 ? m.diffuse_texture : m.emission_texture;
        if (texture < 0) continue;
        const Texture& t = s.textures[static_cast<std::size_t>(texture)];
        const uvec3 c = s.triangles[i];
        const vec2 du = s.texcoords[c.y] - s.texcoords[c.x];
        const vec2 dv = s.texcoords[c.z] - s.texcoords[c.x];
        const double texels =
            std::abs(double{du.x} * dv.y - double{du.y} * dv.x) * t.width * t.height;
        const double area = glm::length(glm::dvec3(glm::cross(
            s.positions_m[c.y] - s.positions_m[c.x], s.positions_m[c.z] - s.positions_m[c.x])));
        // A triangle without area in space or in the texture shows one texel: any level will do.
        texel_density_log2_[i] =
            texels > 0.0 && area > 0.0 ? static_cast<float>(0.5 * std::log2(texels / area)) : 0.0F;
    }
}

void EmbreeScene::build_textures() {
    std::array<float, 256> linear{};
    for (std::size_t i = 0; i < linear.size(); ++i) {
        const double c = static_cast<double>(i) / 255.0;
        linear[i] =
            static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
    }
    linear_texels_.reserve(source_.texels.size());
    for (const std::uint32_t c : source_.texels)
        linear_texels_.push_back(
            pack_half4({linear[c & 255U], linear[(c >> 8U) & 255U], linear[(c >> 16U) & 255U],
                        static_cast<float>(c >> 24U) / 255.0F}));
    mips_.resize(source_.textures.size() * kMostLevels);
    for (std::size_t t = 0; t < source_.textures.size(); ++t) {
        const Texture& texture = source_.textures[t];
        MipLevel mip{texture.first_texel, static_cast<std::int32_t>(texture.width),
                     static_cast<std::int32_t>(texture.height)};
        for (std::uint32_t level = 0; level < texture.level_count && level < kMostLevels; ++level) {
            mips_[t * kMostLevels + level] = mip;
            mip = {mip.first + static_cast<std::uint32_t>(mip.width * mip.height),
                   std::max(1, mip.width / 2), std::max(1, mip.height / 2)};
        }
    }
}

void EmbreeScene::attach_parts(const EmbreeSettings& settings) {
    scene_ = SceneHandle(rtcNewScene(device_.get()));
    bool moves = false;
    for (const Part& part : source_.parts) moves = moves || (settings.motion && part.motion >= 0);
    if (moves) {
        normals_ = source_.normals;
        view_.normals = view_of(std::as_const(normals_));
    }
    const bool splits = source_.triangles.size() <= kMostTrianglesForSplits && !moves;
    rtcSetSceneBuildQuality(scene_.get(),
                            splits ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM);
    rtcSetSceneFlags(scene_.get(),
                     static_cast<RTCSceneFlags>((settings.robust ? RTC_SCENE_FLAG_ROBUST : 0) |
                                                (moves ? RTC_SCENE_FLAG_DYNAMIC : 0)));
    for (const Part& part : source_.parts) {
        auto held = std::make_unique<PartGeometry>();
        held->masked = {&view_, part.first_triangle};
        held->geometry = Geometry(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
        const RTCGeometry g = held->geometry.get();
        if (moves && part.motion >= 0) rtcSetGeometryBuildQuality(g, RTC_BUILD_QUALITY_REFIT);
        rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                   positions_m_.data(), 0, sizeof(vec3),
                                   source_.positions_m.size());
        rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                   source_.triangles.data() + part.first_triangle, 0, sizeof(uvec3),
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
    bool moved_any = false;
    for (std::size_t i = 0; i < source_.parts.size(); ++i) {
        const Part& part = source_.parts[i];
        if (part.motion < 0) continue;
        const Motion& motion = source_.motions[static_cast<std::size_t>(part.motion)];
        const quat turn = turn_of(motion, time_s);
        const vec3 shift = motion.pivot_m + shift_of(motion, time_s);
        for (std::uint32_t v = part.first_vertex; v < part.first_vertex + part.vertex_count; ++v) {
            positions_m_[v] = shift + turn * (source_.positions_m[v] - motion.pivot_m);
            normals_[v] = turn * source_.normals[v];
        }
        rtcUpdateGeometryBuffer(parts_[i]->geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0);
        rtcCommitGeometry(parts_[i]->geometry.get());
        moved_any = true;
    }
    if (moved_any) rtcCommitScene(scene_.get());
}

SceneBytes EmbreeScene::bytes() const {
    const auto of = [](const auto& v) { return v.capacity() * sizeof v[0]; };
    SceneBytes bytes;
    bytes.base = static_cast<std::uint64_t>(embree_bytes_.load(std::memory_order_relaxed)) +
                 of(positions_m_) + of(first_triangles_) + parts_.size() * sizeof(PartGeometry);
    bytes.textures = of(texel_density_log2_) + of(linear_texels_) + of(mips_);
    bytes.motion = of(normals_);
    return bytes;
}

}  // namespace foverig::embree
