#pragma once
#include <cstddef>
#include <vector>

namespace foverig::metrics {

/// One number a pixel, row by row from the top.
struct Plane {
    int width_px = 0;
    int height_px = 0;
    std::vector<float> values;

    Plane() = default;
    Plane(int width, int height)
        : width_px(width),
          height_px(height),
          values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

    float* row(int y) {
        return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px);
    }
    const float* row(int y) const { return const_cast<Plane*>(this)->row(y); }
};

}  // namespace foverig::metrics
