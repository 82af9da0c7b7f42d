#pragma once
#include <cstdint>

#include "renderer/hd.h"

namespace foverig {

/// A pixel of an eye image in one word; what queues hold: x in 16 bits, y in 15, the eye in one.
using PackedPixel = std::uint32_t;

RIG_INLINE PackedPixel pack_pixel(std::uint32_t x, std::uint32_t y) {
    return x | (y << 16U);
}
RIG_INLINE PackedPixel of_eye(PackedPixel p, std::uint32_t eye) {
    return p | (eye << 31U);
}
RIG_INLINE std::uint32_t pixel_x(PackedPixel p) {
    return p & 0xFFFFU;
}
RIG_INLINE std::uint32_t pixel_y(PackedPixel p) {
    return (p >> 16U) & 0x7FFFU;
}
RIG_INLINE std::uint32_t pixel_eye(PackedPixel p) {
    return p >> 31U;
}

}  // namespace foverig
