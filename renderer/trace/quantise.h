#pragma once
// Boxes to bytes, outwards (Ylitie 2017).
#include <bit>
#include <cmath>

#include "renderer/trace/packed_bvh.h"

namespace foverig {

/// Smallest stored exponent whose 255 steps reach `extent_m`.
RIG_HD inline std::uint8_t grid_exponent(double extent_m) {
    if (!(extent_m > 0.0)) return 0;
    const auto least = static_cast<float>(extent_m / 255.0 * (1.0 + 1.0e-6));
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(least);
    const std::uint32_t up = (bits >> 23U) + ((bits & 0x7FFFFFU) != 0U ? 1U : 0U);
    return static_cast<std::uint8_t>(up < 1U ? 1U : up > 254U ? 254U : up);
}

/// Sets origin, exponents and bounds so that each child's box is held; an empty box becomes one
/// that no ray meets. Leaves the rest of the node as it is.
RIG_HD inline void set_boxes(WideNode& node, const Box (&children)[kWidth]) {
    Box all;
    for (const Box& child : children) all.grow(child);
    for (int a = 0; a < 3; ++a) {
        const bool any = !all.empty();
        const double origin = any ? double{all.min_m[a]} : 0.0;
        node.origin_m[a] = any ? all.min_m[a] : 0.0F;
        node.exponent[a] = any ? grid_exponent(double{all.max_m[a]} - origin) : std::uint8_t{127};
        const double step = double{std::bit_cast<float>(std::uint32_t{node.exponent[a]} << 23U)};
        const double steps_per_m = step > 0.0 ? 1.0 / step : 0.0;
        for (int slot = 0; slot < kWidth; ++slot) {
            const Box& box = children[slot];
            const double low = (double{box.min_m[a]} - origin) * steps_per_m;
            const double high = (double{box.max_m[a]} - origin) * steps_per_m;
            node.bounds[a][slot] =
                box.empty() ? std::uint8_t{255} : static_cast<std::uint8_t>(std::floor(low));
            node.bounds[3 + a][slot] =
                box.empty() ? std::uint8_t{0}
                            : static_cast<std::uint8_t>(std::fmin(std::ceil(high), 255.0));
        }
    }
}

}  // namespace foverig
