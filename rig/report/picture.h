#pragma once
// Pictures inside a page: read back from the run folder, made smaller, encoded again.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace foverig::report {

struct Picture {
    int width_px = 0;
    int height_px = 0;
    std::vector<std::uint8_t> rgb;  ///< sRGB, three bytes a pixel
};

/// Throws InputError with the file's name.
Picture read_png(const std::filesystem::path& file);

/// Box filter; never enlarges. Averages linear light, as a display far away would.
Picture shrunk(const Picture& picture, int most_width_px);

/// A square around a place, moved to lie inside.
Picture cropped(const Picture& picture, double x_px, double y_px, int size_px);

/// "data:image/jpeg;base64,..." of a photograph-like picture.
std::string jpeg_uri(const Picture& picture, int quality);

}  // namespace foverig::report
