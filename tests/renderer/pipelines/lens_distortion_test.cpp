#include "renderer/pipelines/lens_distortion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "renderer/check.h"

namespace foverig {
namespace {

using Tables = std::vector<std::vector<ColourSources>>;
using Images = std::vector<Image>;

constexpr int kWidth = 37;
constexpr int kHeight = 23;

/// A different value in every pixel and channel, each a half's own.
Image pattern(int width_px, int height_px, float shift = 0.0F) {
    Image image{width_px, height_px, {}};
    for (int y = 0; y < height_px; ++y)
        for (int x = 0; x < width_px; ++x)
            image.pixels.emplace_back(shift + static_cast<float>(x), 100.0F + static_cast<float>(y),
                                      static_cast<float>(x * x - y * x));
    return image;
}

std::vector<ColourSources> table(const std::function<ColourSources(float x, float y)>& source) {
    std::vector<ColourSources> t;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            t.push_back(source(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F));
    return t;
}

ColourSources same_place(float x, float y) {
    return {vec2(x, y), vec2(x, y), vec2(x, y)};
}

Image distorted(const Tables& tables, const Images& eyes, int threads = 0,
                const PixelSize& eye_size = {kWidth, kHeight}) {
    std::vector<std::vector<Half4>> halves;
    std::vector<View<const Half4>> views;
    for (const Image& eye : eyes) {
        auto& packed = halves.emplace_back();
        for (const vec3& pixel : eye.pixels) packed.push_back(pack_half4(vec4(pixel, 0.0F)));
        views.push_back(view_of(std::as_const(packed)));
    }
    Image panel{1, 1, {vec3(9.0F)}};  // what was there is overwritten
    LensDistortion({kWidth, kHeight}, eye_size, tables, threads).apply(views, panel);
    return panel;
}

TEST(LensDistortion, AnIdentityTableReturnsTheImage) {
    const Tables tables{table(same_place)};
    const Images eyes{pattern(kWidth, kHeight)};
    const Image panel = distorted(tables, eyes);
    EXPECT_EQ(panel.width_px, kWidth);
    EXPECT_EQ(panel.height_px, kHeight);
    EXPECT_EQ(panel.pixels, eyes[0].pixels);
}

TEST(LensDistortion, OutsideAndNanAreBlackAColourAtATime) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto source = [&](float x, float y) -> ColourSources {
        return {vec2(x - 10.0F, y), vec2(x, y + 5.0F), x > 30.0F ? vec2(nan, y) : vec2(x, y)};
    };
    const Tables tables{table(source)};
    const Images eyes{pattern(kWidth, kHeight, 1.0F)};
    const Image panel = distorted(tables, eyes);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const vec3 expected(x >= 10 ? eyes[0].at(x - 10, y).x : 0.0F,
                                y + 5 < kHeight ? eyes[0].at(x, y + 5).y : 0.0F,
                                x < 30 ? eyes[0].at(x, y).z : 0.0F);
            ASSERT_EQ(panel.at(x, y), expected) << x << ' ' << y;
        }
    }
}

TEST(LensDistortion, ALookupBetweenPixelsIsBilinearInEachColoursOwnPlace) {
    const auto source = [](float x, float y) -> ColourSources {
        return {vec2(x + 0.25F, y), vec2(x, y - 0.5F), vec2(0.5F * x, 0.5F * y)};
    };
    const Tables tables{table(source)};
    const Images eyes{pattern(kWidth, kHeight)};
    const Image& eye = eyes[0];
    const Image panel = distorted(tables, eyes);
    for (int y = 1; y < kHeight; ++y) {
        for (int x = 1; x + 1 < kWidth; ++x) {
            ASSERT_FLOAT_EQ(panel.at(x, y).x, static_cast<float>(x) + 0.25F);
            ASSERT_FLOAT_EQ(panel.at(x, y).y, 100.0F + static_cast<float>(y) - 0.5F);
            const double fx = 0.5 * (x + 0.5) - 0.5;
            const double fy = 0.5 * (y + 0.5) - 0.5;
            const int x0 = static_cast<int>(fx);
            const int y0 = static_cast<int>(fy);
            const double u = fx - x0;
            const double v = fy - y0;
            const double expected =
                (1 - u) * (1 - v) * eye.at(x0, y0).z + u * (1 - v) * eye.at(x0 + 1, y0).z +
                (1 - u) * v * eye.at(x0, y0 + 1).z + u * v * eye.at(x0 + 1, y0 + 1).z;
            ASSERT_NEAR(panel.at(x, y).z, expected, 1.0e-4 * (1.0 + std::abs(expected)));
        }
    }
}

TEST(LensDistortion, TheImagesVeryEdgeIsStillInsideAndHeld) {
    const auto source = [](float x, float y) -> ColourSources {
        return {vec2(0.0F, y), vec2(static_cast<float>(kWidth), static_cast<float>(kHeight)),
                vec2(x, -1.0e-3F)};
    };
    const Tables tables{table(source)};
    const Images eyes{pattern(kWidth, kHeight, 7.0F)};
    const Image panel = distorted(tables, eyes);
    EXPECT_EQ(panel.at(5, 5).x, eyes[0].at(0, 5).x);
    EXPECT_EQ(panel.at(5, 5).y, eyes[0].at(kWidth - 1, kHeight - 1).y);
    EXPECT_EQ(panel.at(5, 5).z, 0.0F);
}

TEST(LensDistortion, EyesLieSideBySideAndAnEmptyOneIsBlack) {
    const Tables tables{table(same_place), table(same_place)};
    const Images both{pattern(kWidth, kHeight), pattern(kWidth, kHeight, 50.0F)};
    const Image panel = distorted(tables, both);
    ASSERT_EQ(panel.width_px, 2 * kWidth);
    EXPECT_EQ(panel.at(3, 4), both[0].at(3, 4));
    EXPECT_EQ(panel.at(kWidth + 3, 4), both[1].at(3, 4));
    const Image right_only = distorted(tables, {Image{}, both[1]});
    EXPECT_EQ(right_only.at(3, 4), vec3(0.0F));
    EXPECT_EQ(right_only.at(kWidth + 3, 4), both[1].at(3, 4));
}

TEST(LensDistortion, ThreadsDoNotChangeABit) {
    const auto source = [](float x, float y) -> ColourSources {
        return {vec2(1.01F * x, y), vec2(x, 0.97F * y), vec2(0.9F * x + 0.1F * y, y)};
    };
    const Tables tables{table(source)};
    const Images eyes{pattern(53, 19)};
    EXPECT_EQ(distorted(tables, eyes, 1, {53, 19}).pixels,
              distorted(tables, eyes, 4, {53, 19}).pixels);
}

TEST(LensDistortion, ATableOfTheWrongSizeIsRefused) {
    const Tables tables{std::vector<ColourSources>(kWidth)};
    EXPECT_THROW(LensDistortion({kWidth, kHeight}, {kWidth, kHeight}, tables), InternalError);
}

}  // namespace
}  // namespace foverig
