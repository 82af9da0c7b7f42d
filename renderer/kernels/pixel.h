#pragma once
#include <cstdint>

#include "renderer/hd.h"

namespace foverig {

/// A pixel of an eye image in one word; what queues hold.
using PackedPixel = std::uint32_t;

RIG_INLINE PackedPixel pack_pixel(std::uint32_t x, std::uint32_t y) {
    return x | (y << 16U);
}
RIG_INLINE std::uint32_t pixel_x(PackedPixel p) {
    return p & 0xFFFFU;
}
RIG_INLINE std::uint32_t pixel_y(PackedPixel p) {
    return p >> 16U;
}

}  // namespace foverig
