#pragma once
#include "renderer/kernels/camera_rays.h"
#include "renderer/kernels/surface.h"
#include "renderer/kernels/texture.h"

namespace foverig {

RIG_INLINE float largest_coordinate(const vec3& p) {
    return max_of(max_of(fabsf(p.x), fabsf(p.y)), fabsf(p.z));
}

/// How far off the surface a secondary ray starts. The hit point is interpolated from the corners,
/// so its error is a few ulps (2^-23) of their largest coordinate; 32 ulps leave room for the
/// tracer's own.
RIG_INLINE float origin_offset_m(const vec3& a, const vec3& b, const vec3& c) {
    return max_of(max_of(largest_coordinate(a), largest_coordinate(b)), largest_coordinate(c)) *
           0x1.0p-18F;
}

/// Turns hits into surface records (Weier 2016 3.1): position, normal, mip-mapped material, ambient
/// and emitted light. `slots[i]` is where pixel i goes; misses have none (kMiss).
template <bool kTextures, bool kOcclusion, bool kLightBuffer>
struct ShadeSurface {
    SceneView scene;
    EyeRays eye;
    View<const PackedPixel> pixels;
    View<const Hit> hits;
    View<const std::uint32_t> slots;
    Surfaces surfaces;
    float log2_pixel_width;  ///< of the width of a pixel at depth 1

    RIG_HD void operator()(int i) const {
        const auto pixel = static_cast<std::size_t>(i);
        const std::uint32_t target = slots[pixel];
        if (target == kMiss) return;
        const int slot = static_cast<int>(target);
        const Hit hit = hits[pixel];
        const uvec3 corner = scene.triangles[hit.triangle];
        const float w = 1.0F - hit.u - hit.v;
        const vec3 a = scene.positions_m[corner.x];
        const vec3 b = scene.positions_m[corner.y];
        const vec3 c = scene.positions_m[corner.z];
        const vec3 position = w * a + hit.u * b + hit.v * c;
        const vec3 view = glm::normalize(eye.origin_m - position);
        vec3 geometric = glm::cross(b - a, c - a);
        const float length2 = glm::dot(geometric, geometric);
        geometric = length2 > 0.0F ? geometric * (1.0F / sqrtf(length2)) : view;
        const float facing = glm::dot(geometric, view);
        if (facing < 0.0F) geometric = -geometric;
        vec3 normal = w * scene.normals[corner.x] + hit.u * scene.normals[corner.y] +
                      hit.v * scene.normals[corner.z];
        const float normal2 = glm::dot(normal, normal);
        normal = normal2 > 1.0e-12F ? normal * (1.0F / sqrtf(normal2)) : geometric;
        if (glm::dot(normal, geometric) < 0.0F) normal = -normal;

        const Material& material = scene.materials[scene.triangle_materials[hit.triangle]];
        vec3 diffuse = material.diffuse;
        vec3 emission = material.emission;
        if constexpr (kTextures) {
            if (material.diffuse_texture >= 0 || material.emission_texture >= 0) {
                const vec2 uv = w * scene.texcoords[corner.x] + hit.u * scene.texcoords[corner.y] +
                                hit.v * scene.texcoords[corner.z];
                // Footprint: the pixel's width at this depth, stretched by the slant (at most 16).
                const float lod = scene.texel_density_log2[hit.triangle] + log2_pixel_width +
                                  log2f(hit.t / max_of(fabsf(facing), 1.0F / 16.0F));
                if (material.diffuse_texture >= 0)
                    diffuse *= vec3(sample_texture(scene, material.diffuse_texture, uv, lod));
                if (material.emission_texture >= 0)
                    emission *= vec3(sample_texture(scene, material.emission_texture, uv, lod));
            }
        }
        surfaces.set3(Row::origin_x, slot, position + geometric * origin_offset_m(a, b, c));
        surfaces.set3(Row::normal_x, slot, normal);
        surfaces.set3(Row::diffuse_r, slot, diffuse);
        surfaces.set3(Row::specular_r, slot, material.specular);
        surfaces.at(Row::shininess, slot) = material.shininess;
        surfaces.set3(Row::view_x, slot, view);
        // With occlusion on, ambient light belongs to the light buffer and is added by `compose`.
        const vec3 ambient = kOcclusion ? vec3(0.0F) : diffuse * scene.ambient;
        surfaces.set3(Row::colour_r, slot, emission + ambient);
        surfaces.at(Row::depth, slot) = hit.t;
        if constexpr (kLightBuffer) {
            surfaces.set3(Row::irradiance_r, slot, vec3(0.0F));
            surfaces.at(Row::occlusion, slot) = 1.0F;
        }
    }
};

}  // namespace foverig
