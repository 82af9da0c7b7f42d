#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "renderer/image_formats.h"

namespace foverig::image_formats {
namespace {

/// The next word of the header, and what is left after the one white space behind it.
std::string_view next_word(std::string_view& rest) {
    constexpr std::string_view kSpace = " \t\r\n";
    const std::size_t begin = rest.find_first_not_of(kSpace);
    if (begin == std::string_view::npos) throw FormatError("is a PFM whose header is cut off");
    const std::size_t end = rest.find_first_of(kSpace, begin);
    if (end == std::string_view::npos) throw FormatError("is a PFM whose header is cut off");
    const std::string_view word = rest.substr(begin, end - begin);
    rest.remove_prefix(end + 1);
    return word;
}

template <class Number>
Number number_of(std::string_view word) {
    Number number{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size())
        throw FormatError(fmt::format("is a PFM whose header says '{}' for a number", word));
    return number;
}

float value_at(const char* bytes, bool little_endian) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, bytes, sizeof(bits));
    if (little_endian != (std::endian::native == std::endian::little))
        bits = __builtin_bswap32(bits);
    return std::bit_cast<float>(bits);
}

}  // namespace

Image decode_pfm(std::string_view bytes) {
    std::string_view rest = bytes;
    const std::size_t channels = next_word(rest) == "PF" ? 3 : 1;
    const auto width = number_of<int>(next_word(rest));
    const auto height = number_of<int>(next_word(rest));
    const auto scale = number_of<double>(next_word(rest));  // its sign is the order of bytes
    if (scale == 0.0 || !std::isfinite(scale)) throw FormatError("is a PFM without a scale");
    Image image = blank_image(width, height, bytes.size(), 1);
    const std::size_t row_bytes = static_cast<std::size_t>(width) * channels * sizeof(float);
    if (rest.size() < row_bytes * static_cast<std::size_t>(height))
        throw FormatError(fmt::format("is a PFM cut off after {} of its {} bytes of pixels",
                                      rest.size(), row_bytes * static_cast<std::size_t>(height)));
    for (int y = 0; y < height; ++y) {
        const char* row = rest.data() + row_bytes * static_cast<std::size_t>(height - 1 - y);
        for (std::size_t x = 0; x < static_cast<std::size_t>(width); ++x)
            for (std::size_t c = 0; c < 3; ++c)
                image.at(static_cast<int>(x), y)[static_cast<int>(c)] = value_at(
                    row + sizeof(float) * (x * channels + std::min(c, channels - 1)), scale < 0.0);
    }
    return image;
}

}  // namespace foverig::image_formats
