#include <fmt/format.h>
#include <png.h>

#include <array>
#include <memory>

#include "renderer/image_formats.h"

namespace foverig::image_formats {
namespace {

std::array<float, 256> linear_of_codes() {
    std::array<float, 256> linear{};
    for (std::size_t i = 0; i < linear.size(); ++i)
        linear[i] = linear_from_srgb(static_cast<float>(i) / 255.0F);
    return linear;
}

void read_rows(png_image& png, void* rows) {
    constexpr png_color kBlack{0, 0, 0};
    if (png_image_finish_read(&png, &kBlack, rows, 0, nullptr) == 0)
        throw FormatError(fmt::format("is a PNG that libpng rejects ({})", png.message));
}

}  // namespace

Image decode_png(std::string_view bytes) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    const std::unique_ptr<png_image, decltype(&png_image_free)> guard(&png, &png_image_free);
    if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0)
        throw FormatError(fmt::format("is a PNG that libpng rejects ({})", png.message));
    // Deflate shrinks at most 1032 times, and a PNG pixel has at least 1 bit.
    Image image = blank_image(png.width, png.height, bytes.size(), 8 * 1032);
    if ((png.format & PNG_FORMAT_FLAG_LINEAR) != 0) {  // libpng's word for 16 bits
        decode_png16(bytes, image);
        return image;
    }
    const std::size_t count = image.pixels.size();
    png.format = PNG_FORMAT_RGB;
    std::vector<std::uint8_t> codes(count * 3);
    read_rows(png, codes.data());
    const auto linear = linear_of_codes();
    for (std::size_t i = 0; i < count; ++i)
        image.pixels[i] = {linear[codes[3 * i]], linear[codes[3 * i + 1]],
                           linear[codes[3 * i + 2]]};
    return image;
}

}  // namespace foverig::image_formats
