#pragma once
// A head that moves through a built-in scene, and how its frames compare to `full`.
#include <algorithm>
#include <cmath>
#include <map>

#include "renderer/foveation/foveal_function.h"
#include "renderer/kernels/camera_rays.h"
#include "renderer/scene/library.h"
#include "tests/renderer/small_scenes.h"

namespace foverig {

inline constexpr int kFlightWidth = 320;
inline constexpr int kFlightHeight = 396;
inline constexpr double kRate_hz = 75.0;

inline std::shared_ptr<const Scene> builtin(const char* name) {
    static std::map<std::string, std::shared_ptr<const Scene>> made;
    auto& scene = made[name];
    if (scene == nullptr) scene = std::make_shared<const Scene>(make_builtin_scene(name, 0.5));
    return scene;
}

/// A head that drifts and turns around the scene's first camera key.
inline EyeView moving_view(const Scene& scene, int frame, int width_px = kFlightWidth,
                           int height_px = kFlightHeight) {
    const CameraKey& key = scene.camera_path[0];
    const float t = static_cast<float>(frame) * 0.02F;
    return view_at(key.position_m + vec3(0.3F * std::sin(t), 0.1F * t, -0.2F * t),
                   key.target_m + vec3(0.5F * std::sin(2.0F * t), 0.0F, 0.0F), width_px, height_px,
                   1.08F);
}

inline FrameInput input_at(const Scene& scene, int frame, bool still = false,
                           int width_px = kFlightWidth, int height_px = kFlightHeight) {
    FrameInput input = frame_of(moving_view(scene, still ? 0 : frame, width_px, height_px),
                                static_cast<std::uint32_t>(frame));
    input.time_s = still ? 0.0 : frame / kRate_hz;
    input.eyes[0].gaze = glm::normalize(
        vec3(0.1F * std::cos(0.3F * static_cast<float>(still ? 0 : frame)), -0.08F, -1.0F));
    return input;
}

inline RenderSettings only_point_light() {
    RenderSettings s = settings_of("reprojected");
    s.lighting.area_lights = false;
    return s;
}

inline RenderSettings all_light() {
    RenderSettings s = settings_of("reprojected");
    s.lighting.area_samples = 4;
    s.lighting.ao_samples = 2;
    s.lighting.ao_radius_m = 1.0;
    return s;
}

inline RenderSettings as_full(RenderSettings s) {
    s.pipeline = "full";
    return s;
}

struct Difference {
    int compared = 0;
    int different = 0;
    double worst = 0.0;
};

/// Over the pixels whose centres lie within `radius_deg` of the gaze.
inline Difference within(const Image& a, const Image& b, const EyeInput& eye, double radius_deg) {
    Difference d;
    const EyeRays rays(eye.view);
    const dvec3 gaze = dmat3(eye.view.world_from_eye) * dvec3(eye.gaze);
    for (int y = 0; y < a.height_px; ++y) {
        for (int x = 0; x < a.width_px; ++x) {
            if (glm::degrees(angle_between_rad(dvec3(rays.direction(static_cast<float>(x) + 0.5F,
                                                                    static_cast<float>(y) + 0.5F)),
                                               gaze)) > radius_deg)
                continue;
            ++d.compared;
            if (a.at(x, y) == b.at(x, y)) continue;
            ++d.different;
            for (int c = 0; c < 3; ++c)
                d.worst =
                    std::max(d.worst, std::abs(static_cast<double>(a.at(x, y)[c] - b.at(x, y)[c])));
        }
    }
    return d;
}

}  // namespace foverig
