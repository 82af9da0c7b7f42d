#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "renderer/image_formats.h"

namespace foverig::image_formats {
namespace {

/// The bytes of a Radiance picture (Ward, "Real Pixels", Graphics Gems II; radsite filefmts).
class Reader {
  public:
    explicit Reader(std::string_view bytes) : rest_(bytes) {}

    std::string_view line() {
        const std::size_t end = rest_.find('\n');
        if (end == std::string_view::npos) throw FormatError("is an HDR whose header is cut off");
        const std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(end + 1);
        return line;
    }

    std::uint8_t byte() {
        if (rest_.empty()) throw FormatError("is an HDR whose pixels are cut off");
        const auto byte = static_cast<std::uint8_t>(rest_.front());
        rest_.remove_prefix(1);
        return byte;
    }

    std::string_view rest() const { return rest_; }

  private:
    std::string_view rest_;
};

int after(std::string_view& line, std::string_view key) {
    int number = 0;
    if (line.starts_with(key)) {
        line.remove_prefix(key.size());
        const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
        line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    }
    return number;
}

vec3 colour_of(const std::uint8_t* rgbe) {
    if (rgbe[3] == 0) return vec3(0.0F);
    return vec3(rgbe[0], rgbe[1], rgbe[2]) * std::ldexp(1.0F, rgbe[3] - (128 + 8));
}

/// A row whose four components are packed one after the other.
void read_packed(Reader& reader, std::vector<std::uint8_t>& row) {
    const std::size_t width = row.size() / 4;
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t x = 0; x < width;) {
            const std::size_t code = reader.byte();
            const bool run = code > 128;
            const std::size_t count = run ? code - 128 : code;
            if (count == 0 || x + count > width)
                throw FormatError("is an HDR with a run that does not fit its row");
            const std::uint8_t same = run ? reader.byte() : std::uint8_t{0};
            for (std::size_t end = x + count; x < end; ++x)
                row[4 * x + c] = run ? same : reader.byte();
        }
}

void read_row(Reader& reader, std::vector<std::uint8_t>& row) {
    const std::size_t width = row.size() / 4;
    const std::string_view head = reader.rest().substr(0, 4);
    const bool packed = head.size() == 4 && head[0] == 2 && head[1] == 2 &&
                        static_cast<std::size_t>((static_cast<unsigned char>(head[2]) << 8) |
                                                 static_cast<unsigned char>(head[3])) == width;
    if (packed) {
        for (int i = 0; i < 4; ++i) reader.byte();
        read_packed(reader, row);
        return;
    }
    for (std::uint8_t& byte : row) byte = reader.byte();
    for (std::size_t x = 0; x < width; ++x)
        if (row[4 * x] == 1 && row[4 * x + 1] == 1 && row[4 * x + 2] == 1)
            throw FormatError("is an HDR packed the old way; write it again with another tool");
}

}  // namespace

Image decode_rgbe(std::string_view bytes) {
    Reader reader(bytes);
    std::string_view line = reader.line();
    for (; !line.empty(); line = reader.line())
        if (line.starts_with("FORMAT=") && !line.starts_with("FORMAT=32-bit_rle_rgbe"))
            throw FormatError(fmt::format("is an HDR of {}; expected 32-bit_rle_rgbe", line));
    line = reader.line();
    const std::string_view size = line;
    const int height = after(line, "-Y ");
    const int width = after(line, " +X ");
    if (width <= 0 || height <= 0)
        throw FormatError(fmt::format("is an HDR whose size is '{}'; expected -Y N +X N", size));
    Image image = blank_image(width, height, bytes.size(), 16);  // 127 pixels in 8 bytes
    std::vector<std::uint8_t> row(static_cast<std::size_t>(width) * 4);
    for (int y = 0; y < height; ++y) {
        read_row(reader, row);
        for (int x = 0; x < width; ++x)
            image.at(x, y) = colour_of(&row[4 * static_cast<std::size_t>(x)]);
    }
    return image;
}

}  // namespace foverig::image_formats
