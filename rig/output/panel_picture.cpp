#include "rig/output/panel_picture.h"

#include <algorithm>
#include <cmath>

#include "devices/display/dk2_optics.h"

namespace foverig {
namespace {

/// One colour at a place in pixels; pixel centres lie at halves, the edge is held.
float bilinear(const Image& image, double x_px, double y_px, int channel) {
    const double x = std::clamp(x_px - 0.5, 0.0, static_cast<double>(image.width_px - 1));
    const double y = std::clamp(y_px - 0.5, 0.0, static_cast<double>(image.height_px - 1));
    const int x0 = static_cast<int>(x);
    const int y0 = static_cast<int>(y);
    const int x1 = std::min(x0 + 1, image.width_px - 1);
    const int y1 = std::min(y0 + 1, image.height_px - 1);
    const auto u = static_cast<float>(x - x0);
    const auto v = static_cast<float>(y - y0);
    const float top = std::lerp(image.at(x0, y0)[channel], image.at(x1, y0)[channel], u);
    const float bottom = std::lerp(image.at(x0, y1)[channel], image.at(x1, y1)[channel], u);
    return std::lerp(top, bottom, v);
}

void draw_half(Image& panel, const Image& image, Eye eye, const Dk2Optics& optics) {
    if (image.pixels.empty()) return;
    const TangentFrustum frustum = optics.frustum(eye);
    const SizePx half = Dk2Optics::kEyePanel;
    const int left_px = eye == Eye::left ? 0 : half.width;
    for (int y = 0; y < half.height; ++y) {
        for (int x = 0; x < half.width; ++x) {
            const auto tangents = optics.pixel_tangents(eye, x, y);
            vec3 colour(0.0F);
            for (int channel = 0; channel < 3; ++channel) {
                const dvec2 tangent = tangents[static_cast<std::size_t>(channel)];
                const double u = (tangent.x + frustum.left) / (frustum.left + frustum.right);
                const double v = (frustum.up - tangent.y) / (frustum.up + frustum.down);
                if (u < 0.0 || u > 1.0 || v < 0.0 || v > 1.0) continue;
                colour[channel] = bilinear(image, u * image.width_px, v * image.height_px, channel);
            }
            panel.at(left_px + x, y) = colour;
        }
    }
}

}  // namespace

Image panel_picture(const Image& left, const Image& right) {
    const Dk2Optics optics;
    const SizePx half = Dk2Optics::kEyePanel;
    Image panel{2 * half.width, half.height, {}};
    panel.pixels.resize(static_cast<std::size_t>(panel.width_px) *
                        static_cast<std::size_t>(panel.height_px));
    draw_half(panel, left, Eye::left, optics);
    draw_half(panel, right, Eye::right, optics);
    return panel;
}

}  // namespace foverig
