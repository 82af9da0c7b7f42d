#include "rig/session/see_through_lens.h"

#include <algorithm>

namespace foverig {
namespace {

/// Focal lengths and centre, of which a lens without distortion has nothing else.
camera::Lens told(const SeeThroughSettings& settings, int width_px, int height_px) {
    const auto& px = settings.lens_px;
    // Of the whole picture, whose corner lies half a pixel before the first one's centre.
    const dvec2 scale(1.0 * width_px / settings.width_px, 1.0 * height_px / settings.height_px);
    return {.fx_px = px[0] * scale.x,
            .fy_px = px[1] * scale.y,
            .cx_px = (px[2] + 0.5) * scale.x - 0.5,
            .cy_px = (px[3] + 0.5) * scale.y - 0.5};
}

camera::FisheyeLens fisheye(const SeeThroughSettings& settings, camera::Lens straight,
                            int width_px) {
    if (settings.lens_px.empty())
        straight.fx_px = straight.fy_px = width_px / glm::radians(settings.fov_deg);
    camera::FisheyeLens::Numbers numbers{
        straight.fx_px, straight.fy_px, straight.cx_px, straight.cy_px, {}};
    std::ranges::copy(settings.fisheye, numbers.k.begin());
    return camera::FisheyeLens(numbers);
}

}  // namespace

camera::AnyLens lens_of(const SeeThroughSettings& settings, int width_px, int height_px) {
    camera::Lens lens = settings.lens_px.empty()
                            ? camera::ideal_lens(width_px, height_px, settings.fov_deg)
                            : told(settings, width_px, height_px);
    if (!settings.fisheye.empty()) return fisheye(settings, lens, width_px);
    if (const auto& bend = settings.distortion; !bend.empty()) {
        lens.k1 = bend[0];
        lens.k2 = bend[1];
        lens.p1 = bend[2];
        lens.p2 = bend[3];
        lens.k3 = bend[4];
    }
    return lens;
}

}  // namespace foverig
