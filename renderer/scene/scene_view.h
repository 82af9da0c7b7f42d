#pragma once
// What kernels see of a scene: borrowed arrays, and per-triangle numbers that shading wants ready.
#include "renderer/half.h"
#include "renderer/scene/scene.h"
#include "renderer/view.h"

namespace foverig {

/// Where one mip level's texels start and how large it is.
struct MipLevel {
    std::uint32_t first = 0;
    std::int32_t width = 1;
    std::int32_t height = 1;
};

/// A texture of 65536 pixels a side has 17 levels.
inline constexpr std::uint32_t kMostLevels = 17;

struct SceneView {
    View<const vec3> positions_m;  ///< at the frame's time
    View<const vec3> normals;
    View<const vec2> texcoords;
    View<const uvec3> triangles;
    View<const std::uint16_t> triangle_materials;
    View<const float>
        texel_density_log2;  ///< 0.5 log2(texels of level 0 per m^2); empty: no textures
    View<const Material> materials;
    View<const Texture> textures;
    View<const std::uint32_t> texels;  ///< RGBA8: what the alpha test reads
    View<const Half4> linear_texels;   ///< the same texels in linear light: what shading filters
    View<const MipLevel> mips;         ///< level l of texture t at t * kMostLevels + l
    View<const PointLight> point_lights;
    View<const AreaLight> area_lights;
    vec3 ambient{0.0F};
    vec3 background{0.0F};
};

}  // namespace foverig
