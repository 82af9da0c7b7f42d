#pragma once
#include "renderer/camera.h"
#include "renderer/kernels/pixel.h"
#include "renderer/trace/ray.h"
#include "renderer/view.h"

namespace foverig {

/// An eye as kernels use it: ray directions are linear in the pixel. Directions have depth 1 along
/// the view axis, so a ray's t is the view depth in metres.
struct EyeRays {
    vec3 origin_m{0.0F};
    vec3 corner{0.0F};  ///< direction of the image's top left corner
    vec3 step_x{0.0F};  ///< per pixel to the right
    vec3 step_y{0.0F};  ///< per pixel downward

    EyeRays() = default;
    explicit EyeRays(const EyeView& view)
        : origin_m(view.position_m),
          corner(view.world_from_eye * vec3(-view.tan_left, view.tan_up, -1.0F)),
          step_x(view.world_from_eye *
                 vec3((view.tan_left + view.tan_right) / static_cast<float>(view.width_px), 0.0F,
                      0.0F)),
          step_y(view.world_from_eye *
                 vec3(0.0F, -(view.tan_up + view.tan_down) / static_cast<float>(view.height_px),
                      0.0F)) {}

    /// Through image position (x, y) in pixels; a pixel's centre is at +0.5.
    RIG_HD vec3 direction(float x, float y) const { return corner + x * step_x + y * step_y; }
};

/// One primary ray a queued pixel, through its centre plus `jitter_px`.
struct CameraRays {
    EyeRays eye;
    View<const PackedPixel> pixels;
    vec2 jitter_px{0.0F};

    RIG_HD Ray operator()(int i) const {
        const PackedPixel p = pixels[static_cast<std::size_t>(i)];
        Ray ray;
        ray.origin_m = eye.origin_m;
        ray.direction = eye.direction(static_cast<float>(pixel_x(p)) + 0.5F + jitter_px.x,
                                      static_cast<float>(pixel_y(p)) + 0.5F + jitter_px.y);
        return ray;
    }
};

struct StoreHit {
    View<Hit> hits;
    RIG_HD void operator()(int i, const Hit& hit) const { hits[static_cast<std::size_t>(i)] = hit; }
};

}  // namespace foverig
