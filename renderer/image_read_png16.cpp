// PNG of 16 bits a channel. libpng's simple interface hands such files on by a power of 2.2 in
// place of sRGB's curve, so here it is asked for the codes themselves.
#include <fmt/format.h>
#include <png.h>

#include <array>
#include <bit>
#include <csetjmp>
#include <cstring>
#include <vector>

#include "renderer/image_formats.h"

namespace foverig::image_formats {
namespace {

constexpr std::size_t kChannels = 4;

struct Source {
    std::string_view left;
    std::array<char, 128> message{};
};

void on_error(png_structp png, png_const_charp message) {
    auto* const source = static_cast<Source*>(png_get_error_ptr(png));
    std::strncpy(source->message.data(), message, source->message.size() - 1);
    std::longjmp(png_jmpbuf(png), 1);
}

void on_warning(png_structp, png_const_charp) {}

void read_bytes(png_structp png, png_bytep to, std::size_t count) {
    auto* const source = static_cast<Source*>(png_get_io_ptr(png));
    if (count > source->left.size()) png_error(png, "it ends too early");
    std::memcpy(to, source->left.data(), count);
    source->left.remove_prefix(count);
}

/// Fills red, green, blue, alpha in the machine's order of bytes. Nothing here may need a
/// destructor: libpng leaves by longjmp.
bool read_codes(Source& source, png_bytepp rows) {
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, on_error, on_warning);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    if (info == nullptr || setjmp(png_jmpbuf(png)) != 0) {
        png_destroy_read_struct(&png, &info, nullptr);
        return false;
    }
    png_set_read_fn(png, &source, read_bytes);
    png_read_info(png, info);
    png_set_expand(png);  // a transparent colour becomes alpha
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, 0xFFFF, PNG_FILLER_AFTER);
    png_set_swap(png);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    png_read_image(png, rows);
    png_read_end(png, nullptr);
    png_destroy_read_struct(&png, &info, nullptr);
    return true;
}

}  // namespace

void decode_png16(std::string_view bytes, Image& image) {
    static_assert(std::endian::native == std::endian::little);
    const auto width = static_cast<std::size_t>(image.width_px);
    std::vector<std::uint16_t> codes(image.pixels.size() * kChannels);
    std::vector<png_bytep> rows(static_cast<std::size_t>(image.height_px));
    for (std::size_t y = 0; y < rows.size(); ++y)
        rows[y] = reinterpret_cast<png_bytep>(codes.data() + y * width * kChannels);
    Source source{bytes, {}};
    if (!read_codes(source, rows.data()))
        throw FormatError(fmt::format("is a PNG that libpng rejects ({})", source.message.data()));
    const auto value = [](std::uint16_t code) { return static_cast<float>(code) / 65535.0F; };
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const std::uint16_t* const p = codes.data() + i * kChannels;
        // Laid over black, as other formats are.
        image.pixels[i] =
            value(p[3]) * vec3(linear_from_srgb(value(p[0])), linear_from_srgb(value(p[1])),
                               linear_from_srgb(value(p[2])));
    }
}

}  // namespace foverig::image_formats
