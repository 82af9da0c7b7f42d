#pragma once
#include <numbers>

#include "bench/gpu/gpu_scene.h"
#include "renderer/kernels/frame_eyes.h"
#include "renderer/renderer.h"

namespace foverig::gpu {

struct EyeSize {
    int width_px;
    int height_px;
};
inline constexpr EyeSize kDk2Eye{1182, 1464};  // Weier 2016
inline constexpr EyeSize kEye4k{3840, 2160};
inline constexpr double kRate_hz = 75.0;

/// A head at the first key of the camera path that turns by +-20 degrees at 0.4 Hz and sways by
/// 5 cm, one frame after the other at 75 Hz; gaze straight ahead. Two eyes are 64 mm apart.
inline FrameInput flight(const GpuScene& scene, int index, int eyes, const EyeSize& size) {
    const double time_s = index / kRate_hz;
    const auto wave = static_cast<float>(std::sin(2.0 * std::numbers::pi * 0.4 * time_s));
    EyeView view = scene.view(size.width_px, size.height_px);
    const float yaw = 0.349066F * wave;  // 20 degrees
    const mat3 turn(vec3(std::cos(yaw), 0.0F, -std::sin(yaw)), vec3(0.0F, 1.0F, 0.0F),
                    vec3(std::sin(yaw), 0.0F, std::cos(yaw)));
    view.world_from_eye = view.world_from_eye * turn;
    FrameInput input;
    input.frame = static_cast<std::uint32_t>(index);
    input.time_s = time_s;
    for (int eye = 0; eye < eyes; ++eye) {
        EyeInput e;
        e.view = view;
        const float across_m = 0.05F * wave + 0.064F * static_cast<float>(eye);
        e.view.position_m += view.world_from_eye * vec3(across_m, 0.0F, 0.0F);
        input.eyes.push_back(e);
    }
    return input;
}

/// Borrows the scene, for renderers that want to share it.
inline std::shared_ptr<const Scene> shared(const GpuScene& scene) {
    return {std::shared_ptr<const void>(), &scene.scene()};
}

}  // namespace foverig::gpu
