#pragma once
#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace foverig::scene_import {

/// RGBA8 in sRGB, red in the low byte, row by row from the top.
struct RgbaImage {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    bool has_alpha_channel = false;
    std::vector<std::uint32_t> pixels;
};

/// A clause that says what is wrong with the image; whoever knows the file completes the sentence.
struct ImageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Decodes PNG (libpng), JPEG (libjpeg), TGA or BMP (stb_image). Throws ImageError, also for an
/// image of more than `max_px` pixels or one whose header claims more than its bytes can hold.
RgbaImage decode_image(std::string_view bytes, std::uint64_t max_px);

RgbaImage decode_png(std::string_view bytes, std::uint64_t max_px);
RgbaImage decode_jpeg(std::string_view bytes, std::uint64_t max_px);
RgbaImage decode_with_stb(std::string_view bytes, std::uint64_t max_px);

/// Throws ImageError where a header's size is nothing, too large, or not to be had from so few
/// bytes. `max_px_per_byte` is the most that the format's compression can reach.
void check_image_size(std::uint64_t width, std::uint64_t height, std::uint64_t max_px,
                      std::size_t byte_count, std::uint64_t max_px_per_byte);

}  // namespace foverig::scene_import
