#pragma once
// Pictures to draw, and what became of them.
#include <epoxy/gl.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <vector>

#include "devices/display/display.h"
#include "devices/display/panel_view.h"
#include "renderer/half.h"
#include "renderer/image.h"

namespace foverig::test {

inline constexpr int kEyeWidth_px = 591, kEyeHeight_px = 732;  // density 0.5

/// Waves that a bilinear fetch follows well, each colour its own; brighter to the right, and to the
/// top.
inline Image waves(int eye) {
    Image image{kEyeWidth_px, kEyeHeight_px, {}};
    for (int y = 0; y < kEyeHeight_px; ++y) {
        for (int x = 0; x < kEyeWidth_px; ++x) {
            const auto wave = [&](double per_width, double per_height) {
                return 0.5 + 0.3 * std::sin(2.0 * std::numbers::pi *
                                            (per_width * x / kEyeWidth_px +
                                             per_height * y / kEyeHeight_px + 0.3 * eye));
            };
            const double ramp = 0.2 * x / kEyeWidth_px - 0.2 * y / kEyeHeight_px;
            image.pixels.emplace_back(wave(5.0, 2.0) + ramp, wave(1.0, -6.0) + ramp,
                                      wave(-3.0, 3.0) + ramp);
        }
    }
    return image;
}

/// An eye's pixels as a renderer holds them.
class HalfPicture {
  public:
    explicit HalfPicture(const Image& image) : size_{image.width_px, image.height_px} {
        for (const vec3& pixel : image.pixels) halves_.push_back(pack_half4(vec4(pixel, 0.0F)));
    }
    EyePicture view() const {
        return {size_.width, size_.height, [this] { return std::as_bytes(std::span(halves_)); }};
    }

  private:
    SizePx size_;
    std::vector<Half4> halves_;
};

/// Somewhere to paint that no screen has the size of.
class Canvas {
  public:
    Canvas(int width_px, int height_px) {
        glGenFramebuffers(1, &frame_);
        glGenTextures(1, &colour_);
        glBindTexture(GL_TEXTURE_2D, colour_);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_px, height_px, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     nullptr);
        glBindFramebuffer(GL_FRAMEBUFFER, frame_);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_, 0);
    }
    ~Canvas() {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glDeleteFramebuffers(1, &frame_);
        glDeleteTextures(1, &colour_);
    }

  private:
    GLuint frame_ = 0, colour_ = 0;
};

/// What a framebuffer holds, rows from the top, 0..255.
struct Shot {
    int width_px = 0, height_px = 0;
    std::vector<std::uint8_t> rgb;

    const std::uint8_t* at(int x, int y) const {
        return &rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) +
                         static_cast<std::size_t>(x))];
    }
};

inline Shot shot_of_framebuffer(int width_px, int height_px) {
    Shot shot{width_px, height_px, {}};
    const std::size_t row = 3 * static_cast<std::size_t>(width_px);
    std::vector<std::uint8_t> upwards(row * static_cast<std::size_t>(height_px));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width_px, height_px, GL_RGB, GL_UNSIGNED_BYTE, upwards.data());
    for (int y = height_px - 1; y >= 0; --y) {
        const auto first = upwards.begin() + static_cast<std::ptrdiff_t>(row) * y;
        shot.rgb.insert(shot.rgb.end(), first, first + static_cast<std::ptrdiff_t>(row));
    }
    return shot;
}

/// Beside the test program, to look at.
inline void keep(const Shot& shot, const char* name) {
    Image image{shot.width_px, shot.height_px, {}};
    for (std::size_t i = 0; i < shot.rgb.size(); i += 3) {
        const auto linear = [&](std::size_t c) {
            return linear_from_srgb(static_cast<float>(shot.rgb[i + c]) / 255.0F);
        };
        image.pixels.emplace_back(linear(0), linear(1), linear(2));
    }
    const std::filesystem::path folder = std::filesystem::path("window_shots");
    std::filesystem::create_directories(folder);
    write_png(folder / (std::string(name) + ".png"), image);
}

}  // namespace foverig::test
