#include <fmt/format.h>
#include <png.h>

#include <memory>

#include "renderer/scene/image_decode.h"

namespace foverig::scene_import {

RgbaImage decode_png(std::string_view bytes, std::uint64_t max_px) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    const std::unique_ptr<png_image, decltype(&png_image_free)> guard(&png, &png_image_free);
    if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0)
        throw ImageError(fmt::format("is a PNG that libpng rejects ({})", png.message));
    // Deflate shrinks at most 1032 times, and a PNG pixel has at least 1 bit.
    check_image_size(png.width, png.height, max_px, bytes.size(), 8 * 1032);
    RgbaImage image{png.width, png.height, (png.format & PNG_FORMAT_FLAG_ALPHA) != 0, {}};
    png.format = PNG_FORMAT_RGBA;
    image.pixels.resize(std::size_t{png.width} * png.height);
    if (png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr) == 0)
        throw ImageError(fmt::format("is a PNG that libpng rejects ({})", png.message));
    return image;
}

}  // namespace foverig::scene_import
