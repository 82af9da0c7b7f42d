#pragma once
// One decoder a format of image files, from the whole file in memory.
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "renderer/image.h"

namespace foverig::image_formats {

/// A clause that says what is wrong; whoever knows the file completes the sentence.
struct FormatError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Room for that many pixels. Throws where the size is nothing, or too much for the bytes at hand:
/// `max_px_per_byte` is the most that a format can pack.
Image blank_image(std::int64_t width, std::int64_t height, std::size_t byte_count,
                  std::int64_t max_px_per_byte);

Image decode_png(std::string_view bytes);
/// Fills the pixels of an image of the file's size.
void decode_png16(std::string_view bytes, Image& image);
Image decode_pfm(std::string_view bytes);
Image decode_rgbe(std::string_view bytes);
Image decode_exr(std::string_view bytes);

}  // namespace foverig::image_formats
