#pragma once
#include "renderer/kernels/compose.h"
#include "renderer/kernels/path_rays.h"
#include "renderer/kernels/shade_surface.h"

namespace foverig {

/// Surface records of the paths' hits: what every pipeline shades, seen from the path's last
/// vertex. Beyond the first bounce textures are read at their finest level, and lamps are dark to
/// rays from a diffuse surface, whose share of them the light samples bring.
template <bool kTextures, bool kOcclusion, bool kLightBuffer>
struct ShadeVertex {
    SceneView scene;
    PathStates paths;
    View<const Hit> hits;
    View<const std::uint32_t> slots;
    Surfaces surfaces;
    float log2_pixel_width;
    bool primary;

    RIG_HD void operator()(int i) const {
        const std::uint32_t slot = slots[static_cast<std::size_t>(i)];
        if (slot == kMiss) return;
        const std::size_t path = paths.path(i);
        EyeRays from;
        from.origin_m = paths.origin_m[path];
        ShadeSurface<kTextures, kOcclusion, kLightBuffer>{
            scene, from, paths.pixels, hits, slots, surfaces, primary ? log2_pixel_width : kFinest}(
            i);
        if (paths.mirrored[path] == 0) {
            const int s = static_cast<int>(slot);
            surfaces.set3(
                Row::colour_r, s,
                kOcclusion ? vec3(0.0F) : surfaces.get3(Row::diffuse_r, s) * scene.ambient);
        }
    }

    static constexpr float kFinest = -100.0F;
};

/// Rays that left the scene: the background, where it is seen directly or in a mirror. Diffuse
/// surfaces see `ambient` in its stead.
struct GatherMisses {
    PathStates paths;
    View<const std::uint32_t> slots;
    vec3 background;

    RIG_HD void operator()(int i) const {
        const std::size_t path = paths.path(i);
        if (slots[static_cast<std::size_t>(i)] == kMiss && paths.mirrored[path] != 0)
            paths.radiance[path] += paths.throughput[path] * background;
    }
};

/// Gathers what the vertex in `slot` shows, and sends the path on: from a mirror by its share
/// `reflectance`, else from the diffuse surface, cosine-weighted. At the last vertex nothing goes
/// on, and a mirror is shaded as `full` shades it. A path that ends has throughput 0.
template <bool kOcclusion, bool kLightBuffer>
struct LeaveVertex {
    SceneView scene;
    Surfaces surfaces;
    VertexSampler vertex;
    View<const std::uint32_t> triangle_of;  ///< by slot
    bool last;

    RIG_HD void operator()(int slot) const {
        const PathStates& paths = vertex.paths;
        const auto at = static_cast<std::size_t>(slot);
        const std::size_t path = vertex.path_of[at];
        const vec3 diffuse = surfaces.get3(Row::diffuse_r, slot);
        const float mirror =
            last ? 0.0F : scene.materials[scene.triangle_materials[triangle_of[at]]].reflectance;
        vec3 colour = surfaces.get3(Row::colour_r, slot);
        if constexpr (kLightBuffer)
            colour = with_light(colour, diffuse, surfaces.get3(Row::irradiance_r, slot),
                                surfaces.at(Row::occlusion, slot), scene.ambient, kOcclusion);
        vec3& throughput = paths.throughput[path];
        paths.radiance[path] += throughput * ((1.0F - mirror) * colour);
        const vec3 normal = surfaces.get3(Row::normal_x, slot);
        const vec3 view = surfaces.get3(Row::view_x, slot);
        const bool reflects = mirror > 0.0F && vertex.point(slot, kLobePair).x < mirror;
        paths.mirrored[path] = reflects ? 1 : 0;
        paths.origin_m[path] = surfaces.get3(Row::origin_x, slot);
        if (reflects) {
            const float cosine = glm::dot(normal, view);
            paths.direction[path] = 2.0F * cosine * normal - view;
            throughput *= cosine > 0.0F ? 1.0F : 0.0F;
        } else {
            paths.direction[path] =
                frame_about(normal).world(cosine_direction(vertex.point(slot, kDirectionPair)));
            throughput *= diffuse;
        }
    }
};

/// Sums of one half of a pixel's samples, in double: the counts are small, the sums long.
struct HalfSums {
    View<dvec3> sums;  ///< by pixel of the image
    int width_px = 0;
};

struct AccumulatePaths {
    PathStates paths;
    HalfSums half;
    NumericCounts* numerics;

    RIG_HD void operator()(int i) const {
        const auto path = static_cast<std::size_t>(i);
        const PackedPixel p = paths.pixels[path];
        half.sums[static_cast<std::size_t>(pixel_y(p)) * static_cast<std::size_t>(half.width_px) +
                  pixel_x(p)] += dvec3(checked(paths.radiance[path], *numerics));
    }
};

}  // namespace foverig
