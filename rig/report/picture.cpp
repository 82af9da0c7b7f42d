#include "rig/report/picture.h"

#include <cstddef>
#include <cstdio>

// Needs size_t and FILE, which it does not declare.
#include <jpeglib.h>

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "renderer/image.h"
#include "rig/failure.h"

namespace foverig::report {
namespace {

std::string base64(const std::uint8_t* data, std::size_t size) {
    static constexpr char kDigits[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((size + 2) / 3 * 4);
    for (std::size_t i = 0; i < size; i += 3) {
        const std::size_t left = std::min<std::size_t>(3, size - i);
        std::uint32_t bits = 0;
        for (std::size_t j = 0; j < 3; ++j) bits = (bits << 8U) | (j < left ? data[i + j] : 0U);
        for (std::size_t j = 0; j < 4; ++j) {
            text += j <= left ? kDigits[(bits >> (18 - 6 * j)) & 63U] : '=';
        }
    }
    return text;
}

/// 8-bit sRGB to linear light, computed once.
const std::array<float, 256>& linear_table() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = linear_from_srgb(static_cast<float>(i) / 255.0F);
        }
        return values;
    }();
    return table;
}

[[noreturn]] void fail_jpeg(j_common_ptr) {
    throw std::runtime_error("libjpeg cannot encode");
}

}  // namespace

Picture read_png(const std::filesystem::path& file) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_file(&png, file.c_str()) == 0) {
        throw InputError(fmt::format("{}: cannot be read as PNG: {}", file.string(), png.message));
    }
    png.format = PNG_FORMAT_RGB;
    Picture picture{static_cast<int>(png.width), static_cast<int>(png.height), {}};
    picture.rgb.resize(PNG_IMAGE_SIZE(png));
    if (png_image_finish_read(&png, nullptr, picture.rgb.data(), 0, nullptr) == 0) {
        throw InputError(fmt::format("{}: cannot be read as PNG: {}", file.string(), png.message));
    }
    return picture;
}

Picture shrunk(const Picture& picture, int most_width_px) {
    if (picture.width_px <= most_width_px) return picture;
    const int width = most_width_px;
    const int height = std::max(1, picture.height_px * width / picture.width_px);
    Picture small{width, height, {}};
    small.rgb.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    const auto& linear = linear_table();
    const auto edge = [](int i, int n, int full) { return i * full / n; };
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            std::array<float, 3> sum{};
            const int x0 = edge(x, width, picture.width_px);
            const int x1 = edge(x + 1, width, picture.width_px);
            const int y0 = edge(y, height, picture.height_px);
            const int y1 = edge(y + 1, height, picture.height_px);
            for (int sy = y0; sy < y1; ++sy) {
                for (int sx = x0; sx < x1; ++sx) {
                    const std::size_t at = 3 * (static_cast<std::size_t>(sy) *
                                                    static_cast<std::size_t>(picture.width_px) +
                                                static_cast<std::size_t>(sx));
                    for (std::size_t c = 0; c < 3; ++c) sum[c] += linear[picture.rgb[at + c]];
                }
            }
            const auto pixels = static_cast<float>((x1 - x0) * (y1 - y0));
            for (const float channel : sum) {
                const float srgb = srgb_from_linear(channel / pixels);
                small.rgb.push_back(static_cast<std::uint8_t>(std::lround(255.0F * srgb)));
            }
        }
    }
    return small;
}

Picture cropped(const Picture& picture, double x_px, double y_px, int size_px) {
    const int width = std::min(size_px, picture.width_px);
    const int height = std::min(size_px, picture.height_px);
    const auto first = [](double centre, int size, int whole) {
        return std::clamp(static_cast<int>(std::lround(centre)) - size / 2, 0, whole - size);
    };
    const int x0 = first(x_px, width, picture.width_px);
    const int y0 = first(y_px, height, picture.height_px);
    Picture square{width, height, {}};
    for (int y = 0; y < height; ++y) {
        const auto from = picture.rgb.begin() + 3 * ((y0 + y) * picture.width_px + x0);
        square.rgb.insert(square.rgb.end(), from, from + 3 * width);
    }
    return square;
}

std::string jpeg_uri(const Picture& picture, int quality) {
    jpeg_compress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg.err = jpeg_std_error(&errors);
    errors.error_exit = fail_jpeg;
    jpeg_create_compress(&jpeg);
    unsigned char* encoded = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&jpeg, &encoded, &size);
    jpeg.image_width = static_cast<JDIMENSION>(picture.width_px);
    jpeg.image_height = static_cast<JDIMENSION>(picture.height_px);
    jpeg.input_components = 3;
    jpeg.in_color_space = JCS_RGB;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, quality, TRUE);
    jpeg_start_compress(&jpeg, TRUE);
    const std::size_t stride = 3 * static_cast<std::size_t>(picture.width_px);
    while (jpeg.next_scanline < jpeg.image_height) {
        // libjpeg only reads the row, but its interface is not const.
        auto* row = const_cast<JSAMPROW>(picture.rgb.data() + jpeg.next_scanline * stride);
        jpeg_write_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_compress(&jpeg);
    jpeg_destroy_compress(&jpeg);
    const std::string text = "data:image/jpeg;base64," + base64(encoded, size);
    std::free(encoded);
    return text;
}

}  // namespace foverig::report
