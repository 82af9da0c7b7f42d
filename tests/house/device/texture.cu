#include "renderer/kernels/texture.h"

#include "tests/house/device/launch.h"

namespace foverig::device {

__global__ void look_up(SceneView scene, const vec3* uv_lod, vec4* colour, int n) {
    if (index() >= n) return;
    const vec3& at = uv_lod[index()];
    colour[index()] = sample_texture(scene, 0, {at.x, at.y}, at.z);
    colour[index()].w = sample_alpha(scene, scene.textures[0], {at.x, at.y});
}

}  // namespace foverig::device
