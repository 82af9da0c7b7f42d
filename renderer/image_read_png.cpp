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
    const std::size_t count = image.pixels.size();
    if ((png.format & PNG_FORMAT_FLAG_LINEAR) != 0) {
        png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
        png.format = PNG_FORMAT_LINEAR_RGB;
        std::vector<std::uint16_t> values(count * 3);
        // Linear output is not laid over a background: what is transparent comes out dark.
        if (png_image_finish_read(&png, nullptr, values.data(), 0, nullptr) == 0)
            throw FormatError(fmt::format("is a PNG that libpng rejects ({})", png.message));
        for (std::size_t i = 0; i < count; ++i)
            image.pixels[i] =
                vec3(values[3 * i], values[3 * i + 1], values[3 * i + 2]) * (1.0F / 65535.0F);
        return image;
    }
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
