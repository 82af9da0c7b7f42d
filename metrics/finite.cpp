#include "metrics/finite.h"

#include <cmath>

#include "metrics/rows.h"

namespace foverig::metrics {

std::uint64_t count_not_finite(const Image& image) {
    return sum_of_rows<std::uint64_t>(image.height_px, [&](int y) {
        const vec3* row = &image.at(0, y);
        std::uint64_t count = 0;
        for (int x = 0; x < image.width_px; ++x)
            for (int c = 0; c < 3; ++c) count += std::isfinite(row[x][c]) ? 0U : 1U;
        return count;
    });
}

Image with_finite_values(Image image) {
    for_rows(image.height_px, [&](int y) {
        vec3* row = &image.at(0, y);
        for (int x = 0; x < image.width_px; ++x)
            for (int c = 0; c < 3; ++c)
                if (!std::isfinite(row[x][c])) row[x][c] = row[x][c] > 0.0F ? 65504.0F : 0.0F;
    });
    return image;
}

}  // namespace foverig::metrics
