#include "renderer/image.h"

#include <OpenEXR/ImfRgbaFile.h>
#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <stdexcept>
#include <system_error>

namespace foverig {
namespace {

std::uint8_t byte_of(float linear) {
    return static_cast<std::uint8_t>(std::lround(srgb_from_linear(linear) * 255.0F));
}

/// Writes 8-bit samples beside the target and renames: a reader never sees half a file.
void write_png_bytes(const std::filesystem::path& file, int width_px, int height_px,
                     png_uint_32 format, const std::vector<std::uint8_t>& bytes) {
    const std::filesystem::path part = file.string() + ".part";
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(width_px);
    png.height = static_cast<png_uint_32>(height_px);
    png.format = format;
    errno = 0;
    if (png_image_write_to_file(&png, part.c_str(), 0, bytes.data(), 0, nullptr) == 0) {
        const int cause = errno;  // a full disk says so here; libpng only says "Write Error"
        throw std::runtime_error(
            fmt::format("{}: cannot write the image: {}", file.string(),
                        cause != 0 ? std::generic_category().message(cause) : png.message));
    }
    std::filesystem::rename(part, file);
}

}  // namespace

float srgb_from_linear(float linear) {
    if (!(linear > 0.0F)) return 0.0F;
    if (linear >= 1.0F) return 1.0F;
    return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}

float linear_from_srgb(float srgb) {
    return srgb <= 0.04045F ? srgb / 12.92F : std::pow((srgb + 0.055F) / 1.055F, 2.4F);
}

void write_png(const std::filesystem::path& file, const Image& image) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(image.pixels.size() * 3);
    for (const vec3& p : image.pixels)
        for (int c = 0; c < 3; ++c) bytes.push_back(byte_of(p[c]));
    write_png_bytes(file, image.width_px, image.height_px, PNG_FORMAT_RGB, bytes);
}

void write_png(const std::filesystem::path& file, const Mask& mask) {
    std::vector<std::uint8_t> bytes(mask.pixels.size());
    std::transform(mask.pixels.begin(), mask.pixels.end(), bytes.begin(),
                   [](std::uint8_t m) { return m != 0 ? std::uint8_t{255} : std::uint8_t{0}; });
    write_png_bytes(file, mask.width_px, mask.height_px, PNG_FORMAT_GRAY, bytes);
}

void write_exr(const std::filesystem::path& file, const Image& image) {
    const std::filesystem::path part = file.string() + ".part";
    std::vector<Imf::Rgba> rows(image.pixels.size());
    std::transform(image.pixels.begin(), image.pixels.end(), rows.begin(),
                   [](const vec3& p) { return Imf::Rgba(p.x, p.y, p.z); });
    try {
        Imf::RgbaOutputFile out(part.c_str(), image.width_px, image.height_px, Imf::WRITE_RGB);
        out.setFrameBuffer(rows.data(), 1, static_cast<std::size_t>(image.width_px));
        out.writePixels(image.height_px);
    } catch (const std::exception& e) {
        throw std::runtime_error(
            fmt::format("{}: cannot write the image: {}", file.string(), e.what()));
    }
    std::filesystem::rename(part, file);
}

double mean_absolute_error(const Image& a, const Image& b) {
    if (a.width_px != b.width_px || a.height_px != b.height_px)
        throw std::invalid_argument("images of different size have no mean error");
    if (a.pixels.empty()) return 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            sum += std::abs(static_cast<double>(srgb_from_linear(a.pixels[i][c])) -
                            static_cast<double>(srgb_from_linear(b.pixels[i][c])));
    return sum / (3.0 * static_cast<double>(a.pixels.size()));
}

}  // namespace foverig
