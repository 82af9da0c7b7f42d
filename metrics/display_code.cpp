#include "metrics/display_code.h"

#include <fmt/format.h>

#include <stdexcept>

#include "metrics/rows.h"

namespace foverig::metrics {

void check_same_size(const Image& a, const Image& b) {
    if (a.width_px != b.width_px || a.height_px != b.height_px)
        throw std::invalid_argument(
            fmt::format("images of {} x {} and {} x {} pixels cannot be compared; expected one "
                        "size",
                        a.width_px, a.height_px, b.width_px, b.height_px));
}

Plane luma_codes(const Image& image) {
    Plane luma(image.width_px, image.height_px);
    for_rows(image.height_px, [&](int y) {
        const vec3* in = &image.at(0, y);
        float* out = luma.row(y);
        for (int x = 0; x < image.width_px; ++x)
            out[x] = 0.299F * display_code(in[x].x) + 0.587F * display_code(in[x].y) +
                     0.114F * display_code(in[x].z);
    });
    return luma;
}

Plane absolute_error(const Image& a, const Image& b) {
    check_same_size(a, b);
    Plane error(a.width_px, a.height_px);
    for_rows(a.height_px, [&](int y) {
        const vec3* in_a = &a.at(0, y);
        const vec3* in_b = &b.at(0, y);
        float* out = error.row(y);
        for (int x = 0; x < a.width_px; ++x)
            out[x] = (std::abs(display_code(in_a[x].x) - display_code(in_b[x].x)) +
                      std::abs(display_code(in_a[x].y) - display_code(in_b[x].y)) +
                      std::abs(display_code(in_a[x].z) - display_code(in_b[x].z))) *
                     (1.0F / (3.0F * 255.0F));
    });
    return error;
}

}  // namespace foverig::metrics
