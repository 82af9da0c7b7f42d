#include "metrics/pyramid.h"

#include <algorithm>

#include "metrics/rows.h"

namespace foverig::metrics {
namespace {

constexpr float kTaps[5] = {0.05F, 0.25F, 0.4F, 0.25F, 0.05F};

/// Beyond a border lies the outermost sample once more, then the one before it.
int mirrored(int i, int count) {
    if (i < 0) return -i - 1;
    return i < count ? i : 2 * count - 1 - i;
}

/// What lies beyond a row's right end, under the filter that stands on its last kept sample.
float beyond(const std::vector<float>& row, bool odd) {
    const float* end = row.data() + row.size();
    return odd ? kTaps[3] * end[-1] + kTaps[4] * end[-2] : kTaps[4] * end[-1];
}

/// A sample between those of `half`: even ones meet its odd taps, odd ones its even taps.
template <class At>
float between(int i, int count, const At& at) {
    const int centre = i / 2;
    const auto sample = [&](int k) { return at(std::clamp(k, 0, count - 1)); };
    if (i % 2 == 0)
        return 2.0F *
               (kTaps[0] * (sample(centre - 1) + sample(centre + 1)) + kTaps[2] * sample(centre));
    return 2.0F * kTaps[1] * (sample(centre) + sample(centre + 1));
}

}  // namespace

Plane reduced(const Plane& plane) {
    const int width = (plane.width_px + 1) / 2;
    const int height = (plane.height_px + 1) / 2;
    Plane half(width, height);
    for_rows(height, [&](int y) {
        std::vector<float> column(static_cast<std::size_t>(plane.width_px));
        for (int k = -2; k <= 2; ++k) {
            const float* in = plane.row(mirrored(2 * y + k, plane.height_px));
            for (std::size_t x = 0; x < column.size(); ++x) column[x] += kTaps[k + 2] * in[x];
        }
        float* out = half.row(y);
        for (int x = 0; x < width; ++x)
            for (int k = -2; k <= 2; ++k)
                if (const int i = 2 * x + k; i < plane.width_px)
                    out[x] += kTaps[k + 2] *
                              column[static_cast<std::size_t>(mirrored(i, plane.width_px))];
        // By the parity of the height, not of the width: only so FovVideoVDP's numbers come out.
        out[width - 1] += beyond(column, plane.height_px % 2 == 1);
    });
    return half;
}

Plane expanded(const Plane& plane, int width_px, int height_px) {
    Plane whole(width_px, height_px);
    for_rows(height_px, [&](int y) {
        std::vector<float> row(static_cast<std::size_t>(plane.width_px));
        for (int x = 0; x < plane.width_px; ++x)
            row[static_cast<std::size_t>(x)] =
                between(y, plane.height_px, [&](int k) { return plane.row(k)[x]; });
        float* out = whole.row(y);
        for (int x = 0; x < width_px; ++x)
            out[x] =
                between(x, plane.width_px, [&](int k) { return row[static_cast<std::size_t>(k)]; });
    });
    return whole;
}

}  // namespace foverig::metrics
