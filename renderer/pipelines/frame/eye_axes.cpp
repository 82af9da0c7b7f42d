#include "renderer/pipelines/frame/eye_axes.h"

#include <algorithm>
#include <cmath>

namespace foverig {
namespace {

int support_size(int setting_px, int size_px, double paper_support_px, double paper_px) {
    const int wanted = setting_px > 0
                           ? setting_px
                           : static_cast<int>(std::lround(size_px * paper_support_px / paper_px));
    return std::clamp(wanted, 2, std::max(2, size_px));
}

/// Pixel of support sample i: the grid's corners are the image's corner pixels.
int support_pixel(int i, int count, int size_px) {
    return static_cast<int>(std::lround(static_cast<double>(i) * (size_px - 1) / (count - 1)));
}

}  // namespace

EyeAxis::EyeAxis(int count, int size_px)
    : support_of(static_cast<std::size_t>(size_px), std::int16_t{-1}),
      cell_of(static_cast<std::size_t>(size_px)),
      cell_from_px(static_cast<std::size_t>(count) + 1),
      source_px(static_cast<std::size_t>(count)) {
    for (int i = 0; i < count; ++i) {
        const int pixel = support_pixel(i, count, size_px);
        support_of[static_cast<std::size_t>(pixel)] = static_cast<std::int16_t>(i);
        source_px[static_cast<std::size_t>(i)] = static_cast<float>(pixel) + 0.5F;
    }
    // The outermost vertices move out to the image's edge, so that a still eye covers every pixel.
    source_px.front() = 0.0F;
    source_px.back() = static_cast<float>(size_px);
    cell_from_px.back() = static_cast<std::int16_t>(size_px);
    for (int p = size_px - 1; p >= 0; --p) {
        const int cell = p * count / size_px;
        cell_of[static_cast<std::size_t>(p)] = static_cast<std::int16_t>(cell);
        cell_from_px[static_cast<std::size_t>(cell)] = static_cast<std::int16_t>(p);
    }
}

TileGrid support_grid(const ReprojectionSettings& settings, const EyeView& view) {
    return {support_size(settings.support_width_px, view.width_px, 256.0, 1182.0),
            support_size(settings.support_height_px, view.height_px, 318.0, 1464.0)};
}

}  // namespace foverig
