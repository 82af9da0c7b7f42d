#pragma once
#include "renderer/kernels/texture.h"
#include "renderer/trace/ray.h"

namespace foverig {

/// Weier 2016 3.1: fully transparent texels are stepped over in the innermost loop.
RIG_INLINE bool is_hole(const SceneView& scene, std::uint32_t triangle, float u, float v) {
    const Material& material = scene.materials[scene.triangle_materials[triangle]];
    if (material.alpha_cutoff <= 0.0F || material.diffuse_texture < 0) return false;
    const uvec3 corner = scene.triangles[triangle];
    const vec2 uv = (1.0F - u - v) * scene.texcoords[corner.x] + u * scene.texcoords[corner.y] +
                    v * scene.texcoords[corner.z];
    return sample_alpha(scene, scene.textures[static_cast<std::size_t>(material.diffuse_texture)],
                        uv) < material.alpha_cutoff;
}

}  // namespace foverig
