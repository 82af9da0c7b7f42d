#pragma once
#include <cstdint>

#include "renderer/image.h"

namespace foverig::test {

inline Image flat(int width_px, int height_px, const vec3& colour) {
    return {width_px, height_px,
            std::vector<vec3>(static_cast<std::size_t>(width_px * height_px), colour)};
}

/// Linear values of 0 to 1, the same for the same seed.
inline Image noise(int width_px, int height_px, std::uint32_t seed) {
    Image image = flat(width_px, height_px, vec3(0.0F));
    std::uint32_t state = seed * 2654435769U + 1U;
    for (vec3& p : image.pixels)
        for (int c = 0; c < 3; ++c) {
            state = state * 1664525U + 1013904223U;
            p[c] = static_cast<float>(state >> 8U) * 0x1p-24F;
        }
    return image;
}

}  // namespace foverig::test
