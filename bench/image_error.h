#pragma once
#include <cstdint>

#include "renderer/camera.h"
#include "renderer/image.h"

namespace foverig::bench {

/// A foveated image against the full one of the same frame; errors in sRGB, as shares of full
/// scale.
struct ImageError {
    std::uint64_t inside_pixels = 0;  ///< within r0, less a margin for the renderer's quick angle
    std::uint64_t inside_equal = 0;   ///< of those, bit for bit
    double inside_max = 0.0;
    double outside_mean = 0.0;  ///< absolute, over pixels and channels
    double whole_mean = 0.0;
    std::uint64_t not_finite = 0;  ///< values of either image
};

ImageError image_error(const Image& foveated, const Image& full, const EyeInput& eye,
                       double r0_deg);

}  // namespace foverig::bench
