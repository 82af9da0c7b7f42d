#include "renderer/scene/image_decode.h"

#include <fmt/format.h>
#include <png.h>

#include <memory>

namespace foverig::scene_import {

void check_image_size(std::uint64_t width, std::uint64_t height, std::uint64_t max_px,
                      std::size_t byte_count, std::uint64_t max_px_per_byte) {
    if (width == 0 || height == 0) throw ImageError("has no pixels");
    if (width > 65536 || height > 65536 || width * height > max_px)
        throw ImageError(
            fmt::format("claims {} x {} pixels, more than the {} allowed", width, height, max_px));
    if (width * height / max_px_per_byte > byte_count)
        throw ImageError(fmt::format("claims {} x {} pixels, which its {} bytes cannot hold", width,
                                     height, byte_count));
}

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

RgbaImage decode_image(std::string_view bytes, std::uint64_t max_px) {
    if (bytes.starts_with("\x89PNG")) return decode_png(bytes, max_px);
    if (bytes.starts_with("\xFF\xD8")) return decode_jpeg(bytes, max_px);
    if (bytes.starts_with("RIFF") && bytes.substr(8).starts_with("WEBP"))
        throw ImageError("is WebP; convert it to PNG or JPEG");
    if (bytes.starts_with("\xABKTX")) throw ImageError("is KTX; convert it to PNG or JPEG");
    return decode_with_stb(bytes, max_px);
}

}  // namespace foverig::scene_import
