#include "renderer/scene/posed_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace foverig {
namespace {

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

PosedScene::PosedScene(const Scene& scene, const PoseSettings& settings) : source_(scene) {
    positions_m_.reserve(scene.positions_m.size() + 2);
    positions_m_ = scene.positions_m;
    for (std::size_t i = 0; i < scene.parts.size(); ++i)
        if (settings.motion && scene.parts[i].motion >= 0) moving_parts_.push_back(i);
    if (!moving_parts_.empty()) normals_ = scene.normals;
    if (settings.textures && !scene.textures.empty() && !scene.texcoords.empty()) {
        build_texel_density();
        build_textures();
    }
    const Scene& s = scene;
    view_ = {view_of(std::as_const(positions_m_)),
             moving_parts_.empty() ? view_of(s.normals) : view_of(std::as_const(normals_)),
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
}

void PosedScene::build_texel_density() {
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

void PosedScene::build_textures() {
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

void PosedScene::set_time(double time_s) {
    for (const std::size_t i : moving_parts_) {
        const Part& part = source_.parts[i];
        const Motion& motion = source_.motions[static_cast<std::size_t>(part.motion)];
        const quat turn = turn_of(motion, time_s);
        const vec3 shift = motion.pivot_m + shift_of(motion, time_s);
        for (std::uint32_t v = part.first_vertex; v < part.first_vertex + part.vertex_count; ++v) {
            positions_m_[v] = shift + turn * (source_.positions_m[v] - motion.pivot_m);
            normals_[v] = turn * source_.normals[v];
        }
    }
}

SceneBytes PosedScene::bytes() const {
    const auto of = [](const auto& v) { return v.capacity() * sizeof v[0]; };
    return {of(positions_m_), of(texel_density_log2_) + of(linear_texels_) + of(mips_),
            of(normals_)};
}

}  // namespace foverig
