#include "renderer/image_read.h"

#include <fmt/format.h>

#include <fstream>

#include "renderer/image_formats.h"

namespace foverig {
namespace image_formats {

Image blank_image(std::int64_t width, std::int64_t height, std::size_t byte_count,
                  std::int64_t max_px_per_byte) {
    constexpr std::int64_t kMostPixels = 1 << 26;
    if (width <= 0 || height <= 0) throw FormatError("has no pixels");
    if (width > kMostPixels || height > kMostPixels || width * height > kMostPixels)
        throw FormatError(fmt::format("claims {} x {} pixels, more than the {} allowed", width,
                                      height, kMostPixels));
    if (width * height / max_px_per_byte > static_cast<std::int64_t>(byte_count))
        throw FormatError(fmt::format("claims {} x {} pixels, which its {} bytes cannot hold",
                                      width, height, byte_count));
    return {static_cast<int>(width), static_cast<int>(height),
            std::vector<vec3>(static_cast<std::size_t>(width * height))};
}

}  // namespace image_formats
namespace {

std::string bytes_of(const std::filesystem::path& file) {
    if (!std::filesystem::exists(file))
        throw ImageFileError(fmt::format("{}: there is no such file", file.string()));
    if (!std::filesystem::is_regular_file(file))
        throw ImageFileError(fmt::format("{}: is not a file; expected an image", file.string()));
    std::ifstream stream(file, std::ios::binary);
    std::string bytes(std::filesystem::file_size(file), '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!stream) throw ImageFileError(fmt::format("{}: cannot be read", file.string()));
    return bytes;
}

ReadImage decoded(std::string_view bytes) {
    using namespace image_formats;
    if (bytes.starts_with("\x89PNG")) return {decode_png(bytes), false};
    if (bytes.starts_with("PF") || bytes.starts_with("Pf")) return {decode_pfm(bytes), true};
    if (bytes.starts_with("#?")) return {decode_rgbe(bytes), true};
    if (bytes.starts_with("\x76\x2f\x31\x01")) return {decode_exr(bytes), true};
    throw FormatError("is no image that can be read here; expected PNG, PFM, Radiance HDR or EXR");
}

}  // namespace

ReadImage read_image(const std::filesystem::path& file) {
    const std::string bytes = bytes_of(file);
    try {
        return decoded(bytes);
    } catch (const image_formats::FormatError& error) {
        throw ImageFileError(fmt::format("{}: {}", file.string(), error.what()));
    }
}

}  // namespace foverig
