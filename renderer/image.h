#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "renderer/vec.h"

namespace foverig {

/// Linear RGB, row by row from the top.
struct Image {
    int width_px = 0;
    int height_px = 0;
    std::vector<vec3> pixels;

    vec3& at(int x, int y) {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) +
                      static_cast<std::size_t>(x)];
    }
    const vec3& at(int x, int y) const { return const_cast<Image*>(this)->at(x, y); }
};

struct Mask {
    int width_px = 0;
    int height_px = 0;
    std::vector<std::uint8_t> pixels;  ///< 0 or 1
};

/// sRGB of a linear value clamped to [0, 1] (IEC 61966-2-1).
float srgb_from_linear(float linear);
float linear_from_srgb(float srgb);

/// Writes whole or not at all (temporary file, then rename). Throws std::runtime_error with the
/// path.
void write_png(const std::filesystem::path& file, const Image& image);
void write_png(const std::filesystem::path& file, const Mask& mask);
void write_exr(const std::filesystem::path& file, const Image& image);
/// Mean over pixels and channels of |a - b|, both clamped to [0,1] and in sRGB: share of full
/// scale.
double mean_absolute_error(const Image& a, const Image& b);

}  // namespace foverig
