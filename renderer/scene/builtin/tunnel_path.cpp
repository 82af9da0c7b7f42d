#include "renderer/scene/builtin/tunnel_path.h"

namespace foverig::builtin::tunnel {

vec3 axis_m(float along_m) {
    return {2.2F * sine(along_m / 40.0F), 0.5F * sine(along_m / 27.0F + 0.1F), -along_m};
}

void light_and_fly(Scene& scene) {
    for (const float along_m : {7.0F, 23.0F, 39.0F}) {
        const vec3 colour = mix({21.0F, 18.5F, 15.0F}, {15.0F, 18.0F, 21.0F}, along_m / kLength_m);
        scene.point_lights.push_back({axis_m(along_m) + vec3{0.2F, 0.7F, 0.0F}, colour});
    }
    // The strip spans a stretch over which the axis bends less than half its width.
    const vec3 from = axis_m(19.0F) + vec3{-0.4F, 1.35F, 0.0F};
    const vec3 to = axis_m(29.0F) + vec3{-0.4F, 1.35F, 0.0F};
    scene.area_lights = {{from, {0.8F, 0.0F, 0.0F}, to - from, vec3{3.0F, 2.9F, 2.7F}}};
    scene.ambient = vec3{0.3F, 0.3F, 0.32F};
    scene.background = vec3{0.62F, 0.74F, 0.9F};
    constexpr int kKeys = 9;
    for (int i = 0; i < kKeys; ++i) {
        const float along_m = 2.5F + 4.6F * static_cast<float>(i);
        const float sway = 0.35F * sine(static_cast<float>(i) * 0.3F);
        scene.camera_path.push_back(
            {axis_m(along_m) + vec3{sway, 0.1F - 0.3F * sway, 0.0F}, axis_m(along_m + 6.0F)});
    }
    scene.camera_path_s = 20.0F;
}

}  // namespace foverig::builtin::tunnel
