// stb_image for the formats that old OBJ scenes use. PNG and JPEG have their own libraries, but in
// a build for machines without these (FOVERIG_STB_ALONE, scripts/gpu), whose scenes are our own.
#include <climits>
#include <cstring>
#include <memory>

#include "renderer/scene/image_decode.h"

#define STBI_ONLY_TGA
#define STBI_ONLY_BMP
#if defined(FOVERIG_STB_ALONE)
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#endif
#define STBI_NO_STDIO
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace foverig::scene_import {
namespace {

#if defined(FOVERIG_STB_ALONE)
constexpr std::uint64_t kMostPxPerByte = 8 * 1032;  // PNG, see image_png.cpp
#else
constexpr std::uint64_t kMostPxPerByte = 128;
#endif

}  // namespace

#if defined(FOVERIG_STB_ALONE)
RgbaImage decode_png(std::string_view bytes, std::uint64_t max_px) {
    return decode_with_stb(bytes, max_px);
}
RgbaImage decode_jpeg(std::string_view bytes, std::uint64_t max_px) {
    return decode_with_stb(bytes, max_px);
}
#endif

RgbaImage decode_with_stb(std::string_view bytes, std::uint64_t max_px) {
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    if (bytes.empty() || bytes.size() > INT_MAX) throw ImageError("is empty or larger than 2 GiB");
    const int size = static_cast<int>(bytes.size());
    int width = 0;
    int height = 0;
    int channels = 0;
    if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0)
        throw ImageError("is none of PNG, JPEG, TGA and BMP");
    check_image_size(static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height), max_px,
                     bytes.size(), kMostPxPerByte);
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
        stbi_load_from_memory(data, size, &width, &height, &channels, 4), &stbi_image_free);
    if (!pixels) throw ImageError(std::string("cannot be decoded (") + stbi_failure_reason() + ")");
    RgbaImage image{static_cast<std::uint32_t>(width),
                    static_cast<std::uint32_t>(height),
                    channels == 2 || channels == 4,
                    {}};
    image.pixels.resize(std::size_t{image.width} * image.height);
    std::memcpy(image.pixels.data(), pixels.get(), image.pixels.size() * 4);
    return image;
}

}  // namespace foverig::scene_import
