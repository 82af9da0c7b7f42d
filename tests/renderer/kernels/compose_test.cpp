#include "renderer/kernels/compose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace foverig {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(Representable, HoldsEachChannelWithinTheHalves) {
    const float above = std::nextafter(kLargestHalf, kInfinity);
    const float below = std::nextafter(kLargestHalf, 0.0F);
    EXPECT_EQ(representable({0.0F, 0.5F, 1.0e-30F}), vec3(0.0F, 0.5F, 1.0e-30F));
    EXPECT_EQ(representable({below, kLargestHalf, above}), vec3(below, kLargestHalf, kLargestHalf));
    EXPECT_EQ(representable({1.0e30F, kInfinity, -1.0F}), vec3(kLargestHalf, kLargestHalf, 0.0F));
    EXPECT_EQ(representable({kNan, -kInfinity, 2.0F}), vec3(0.0F, 0.0F, 2.0F));
    EXPECT_EQ(representable({2.0F, 1.0F, -kNan}), vec3(2.0F, 1.0F, 0.0F));
}

TEST(Representable, LeavesNoHalfThatIsInfiniteOrNan) {
    for (const float v : {kNan, kInfinity, -kInfinity, 65519.0F, 65520.0F, -65520.0F, 1.0e38F}) {
        const vec4 stored = unpack_half4(pack_half4(vec4(representable(vec3(v)), 0.0F)));
        for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::isfinite(stored[c])) << v;
    }
}

struct Counts {
    std::uint64_t nan, inf, clamped;
};

void expect_checked(const vec3& colour, const vec3& expected, const Counts& expected_counts) {
    SCOPED_TRACE(testing::Message() << colour.x << ", " << colour.y << ", " << colour.z);
    NumericCounts counts;
    EXPECT_EQ(checked(colour, counts), expected);
    EXPECT_EQ(counts.nan, expected_counts.nan);
    EXPECT_EQ(counts.inf, expected_counts.inf);
    EXPECT_EQ(counts.clamped, expected_counts.clamped);
}

TEST(Checked, PassesWhatAHalfCanHold) {
    expect_checked({0.0F, 0.5F, 1.0F}, {0.0F, 0.5F, 1.0F}, {0, 0, 0});
    expect_checked(vec3(kLargestHalf), vec3(kLargestHalf), {0, 0, 0});
}

TEST(Checked, CountsNanAndInfinityAndShowsBlack) {
    for (int c = 0; c < 3; ++c) {
        vec3 colour(1.0F, 2.0F, 3.0F);
        colour[c] = kNan;
        expect_checked(colour, vec3(0.0F), {1, 0, 0});
        colour[c] = kInfinity;
        expect_checked(colour, vec3(0.0F), {0, 1, 0});
        colour[c] = -kInfinity;
        expect_checked(colour, vec3(0.0F), {0, 1, 0});
        colour = vec3(1.0e9F);  // a bad pixel is not a bright one
        colour[c] = kNan;
        expect_checked(colour, vec3(0.0F), {1, 0, 0});
    }
}

TEST(Checked, CountsAndHoldsTooBrightChannels) {
    const float above = std::nextafter(kLargestHalf, kInfinity);
    for (int c = 0; c < 3; ++c)
        for (const float bright : {above, 65520.0F, 1.0e6F, 1.0e30F}) {
            vec3 colour(0.25F, 0.5F, 0.75F);
            vec3 expected = colour;
            colour[c] = bright;
            expected[c] = kLargestHalf;
            expect_checked(colour, expected, {0, 0, 1});
        }
}

TEST(Checked, AddsUp) {
    NumericCounts counts;
    for (int i = 0; i < 3; ++i) checked(vec3(1.0e6F), counts);
    for (int i = 0; i < 5; ++i) checked(vec3(kNan), counts);
    checked(vec3(kInfinity), counts);
    EXPECT_EQ(counts.clamped, 3U);
    EXPECT_EQ(counts.nan, 5U);
    EXPECT_EQ(counts.inf, 1U);
}

TEST(WithLight, AddsReflectedIrradianceAndOpenAmbient) {
    const vec3 colour(0.5F, 0.0F, 2.0F);
    const vec3 diffuse(0.5F, 0.25F, 1.0F);
    const vec3 irradiance(3.0F, 8.0F, 0.0F);
    const vec3 ambient(0.1F, 0.2F, 0.4F);
    for (int c = 0; c < 3; ++c) {
        const double reflected = double{diffuse[c]} * irradiance[c] / std::acos(-1.0);
        const double open = double{diffuse[c]} * ambient[c] * 0.75;
        const double own = double{colour[c]};
        EXPECT_NEAR(with_light(colour, diffuse, irradiance, 0.75F, ambient, true)[c],
                    own + reflected + open, 1.0e-6);
        EXPECT_NEAR(with_light(colour, diffuse, irradiance, 0.75F, ambient, false)[c],
                    own + reflected, 1.0e-6);
    }
}

/// A 3x2 image: pixel (2, 1) sees surface 4, pixel (1, 0) nothing, and one is bad.
struct Composed {
    std::vector<float> rows = std::vector<float>(kRows * 8, 0.0F);
    std::vector<Half4> image = std::vector<Half4>(6, Half4{0x1234567890ABCDEFULL});
    NumericCounts counts;

    template <bool kOcclusion, bool kLightBuffer>
    Composed& compose() {
        const Surfaces surfaces{rows.data(), 8};
        surfaces.set3(Row::colour_r, 4, {0.125F, 0.25F, 0.5F});
        surfaces.set3(Row::diffuse_r, 4, {0.5F, 1.0F, 0.75F});
        surfaces.set3(Row::irradiance_r, 4, {1.0F, 2.0F, 4.0F});
        surfaces.at(Row::occlusion, 4) = 0.5F;
        surfaces.set3(Row::colour_r, 5, {kNan, 1.0F, 1.0F});
        surfaces.set3(Row::colour_r, 6, {1.0F, 1.0e5F, 2.0F});
        const PackedPixel pixels[4] = {pack_pixel(2, 1), pack_pixel(1, 0), pack_pixel(0, 0),
                                       pack_pixel(0, 1)};
        const std::uint32_t slots[4] = {4U, 0xFFFFFFFFU, 5U, 6U};
        const ComposePixels<kOcclusion, kLightBuffer> kernel{
            surfaces,       {pixels, 4}, {slots, 4}, {0.25F, 0.5F, 1.0F}, {0.5F, 0.75F, 0.875F},
            view_of(image), 3,           &counts};
        for (int i = 0; i < 4; ++i) kernel(i);
        return *this;
    }
    vec4 at(int x, int y) const { return unpack_half4(image[static_cast<std::size_t>(y * 3 + x)]); }
};

TEST(ComposePixels, WritesEachPixelAtItsPlace) {
    Composed c;
    c.compose<false, false>();
    EXPECT_EQ(c.at(2, 1), vec4(0.125F, 0.25F, 0.5F, 0.0F));
    EXPECT_EQ(c.at(1, 0), vec4(0.5F, 0.75F, 0.875F, 0.0F));  // background
    EXPECT_EQ(c.at(0, 0), vec4(0.0F));
    EXPECT_EQ(c.at(0, 1), vec4(1.0F, kLargestHalf, 2.0F, 0.0F));
    EXPECT_EQ(c.image[2].bits, 0x1234567890ABCDEFULL);  // not queued
    EXPECT_EQ(c.image[4].bits, 0x1234567890ABCDEFULL);
    EXPECT_EQ(c.counts.nan, 1U);
    EXPECT_EQ(c.counts.inf, 0U);
    EXPECT_EQ(c.counts.clamped, 1U);
}

TEST(ComposePixels, AddsTheLightBuffersShareToHitsAlone) {
    const vec3 colour(0.125F, 0.25F, 0.5F);
    const vec3 diffuse(0.5F, 1.0F, 0.75F);
    const vec3 irradiance(1.0F, 2.0F, 4.0F);
    const vec3 ambient(0.25F, 0.5F, 1.0F);
    Composed image;
    const vec4 closed = image.compose<false, true>().at(2, 1);
    const vec4 open = image.compose<true, true>().at(2, 1);
    for (int c = 0; c < 3; ++c) {
        const double lit_by_area = colour[c] + diffuse[c] * irradiance[c] / std::acos(-1.0);
        EXPECT_NEAR(closed[c], lit_by_area, 1.0e-3);
        EXPECT_NEAR(open[c], lit_by_area + diffuse[c] * ambient[c] * 0.5, 1.0e-3);
    }
    EXPECT_EQ(image.at(1, 0), vec4(0.5F, 0.75F, 0.875F, 0.0F));
}

}  // namespace
}  // namespace foverig
