#include "renderer/scene/image_decode.h"

#include <fmt/format.h>

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

RgbaImage decode_image(std::string_view bytes, std::uint64_t max_px) {
    if (bytes.starts_with("\x89PNG")) return decode_png(bytes, max_px);
    if (bytes.starts_with("\xFF\xD8")) return decode_jpeg(bytes, max_px);
    if (bytes.starts_with("RIFF") && bytes.substr(8).starts_with("WEBP"))
        throw ImageError("is WebP; convert it to PNG or JPEG");
    if (bytes.starts_with("\xABKTX")) throw ImageError("is KTX; convert it to PNG or JPEG");
    return decode_with_stb(bytes, max_px);
}

}  // namespace foverig::scene_import
