#include "renderer/kernels/samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace foverig {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint32_t kMissed = 0xFFFFFFFFU;
constexpr Half4 kOld{0x1234567890ABCDEFULL};
constexpr float kOldDepth_m = -5.0F;
constexpr int kColumns = 5;
constexpr int kRowsOfSupport = 4;
constexpr int kStride = 16;

/// Four traced pixels, of which the third is at hand: surface 9, pixel (14, 6), support sample
/// (3, 2).
struct Stored {
    vec3 colour{0.125F, 0.25F, 0.5F};
    vec3 diffuse{0.5F, 0.75F, 1.0F};
    vec3 irradiance{2.0F, 0.25F, 3.0F};
    float openness = 0.75F;
    float depth_m = 3.5F;
    std::uint32_t slot = 9;
    std::uint8_t flags = kChosenSample;
    vec3 ambient{0.375F, 0.625F, 0.875F};
    vec3 background{0.0625F, 0.03125F, 0.75F};

    vec4 shown{};  ///< what was stored of them
    vec4 base{};
    vec4 shown_diffuse{};
    vec4 light{};
    NumericCounts counts{};
    std::vector<Half4> support_colour = std::vector<Half4>(kColumns * kRowsOfSupport, kOld);
    std::vector<Half4> support_light = support_colour;
    std::vector<float> support_depth_m = std::vector<float>(kColumns * kRowsOfSupport, kOldDepth_m);

    template <bool kOcclusion = true, bool kLightBuffer = true>
    Stored& store() {
        std::vector<float> rows(kLightBuffer ? kRows * kStride : kRowsWithoutLight * kStride, kNan);
        const Surfaces surfaces{rows.data(), kStride};
        surfaces.set3(Row::colour_r, 9, colour);
        surfaces.set3(Row::diffuse_r, 9, diffuse);
        surfaces.at(Row::depth, 9) = depth_m;
        if constexpr (kLightBuffer) {
            surfaces.set3(Row::irradiance_r, 9, irradiance);
            surfaces.at(Row::occlusion, 9) = openness;
        }
        PackedPixel pixels[4] = {0U, 0U, pack_pixel(14, 6), 0U};
        std::uint8_t all_flags[4] = {kSupportSample, kSupportSample, flags, kSupportSample};
        const std::uint32_t slots[4] = {0U, 1U, slot, 2U};
        std::vector<Half4> traced(4 * 4, kOld);
        Half4* const t = traced.data();
        std::vector<std::int16_t> column(20, -1), row(10, -1);
        column[14] = 3;
        row[6] = 2;
        StoreSamples<kOcclusion, kLightBuffer>{
            surfaces,
            {slots, 4},
            {pixels, all_flags, t, kLightBuffer ? t + 4 : nullptr, kLightBuffer ? t + 8 : nullptr,
             kLightBuffer ? t + 12 : nullptr},
            {support_colour.data(), kLightBuffer ? support_light.data() : nullptr,
             support_depth_m.data(), kColumns, kRowsOfSupport},
            column.data(),
            row.data(),
            ambient,
            background,
            &counts}(2);
        shown = unpack_half4(t[2]);
        base = unpack_half4(t[6]);
        shown_diffuse = unpack_half4(t[10]);
        light = unpack_half4(t[14]);
        for (std::size_t i = 0; i < traced.size(); ++i)
            if (i % 4 != 2) {
                EXPECT_EQ(traced[i].bits, kOld.bits) << i;
            }
        return *this;
    }
    std::uint64_t faults() const { return counts.nan + counts.inf + counts.clamped; }
};

void expect_colour(const vec4& value, const dvec3& expected) {
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(value[c], expected[c], 0x1.2p-11 * std::abs(expected[c]) + 1.0e-6) << c;
}

TEST(StoreSamples, AMissIsBackgroundFarAway) {
    Stored s;
    s.slot = kMissed;
    s.flags = kSupportSample;
    s.store();
    EXPECT_EQ(s.shown, vec4(s.background, kInfinity));  // kFarDepth_m in halves
    EXPECT_EQ(vec3(s.base), s.background);
    EXPECT_EQ(vec3(s.shown_diffuse), vec3(0.0F));  // so that no light is added to it later
    EXPECT_EQ(s.light, vec4(0.0F, 0.0F, 0.0F, 1.0F));
    EXPECT_EQ(s.support_depth_m[2 * kColumns + 3], kFarDepth_m);
    EXPECT_EQ(s.faults(), 0U);
}

TEST(StoreSamples, AHitIsItsOwnColourAndTheLightOnIt) {
    // kd (E / pi + ambient * openness), in double.
    Stored s;
    s.store();
    dvec3 expected;
    for (int c = 0; c < 3; ++c)
        expected[c] = s.colour[c] + s.diffuse[c] * (s.irradiance[c] / std::acos(-1.0) +
                                                    double{s.ambient[c]} * s.openness);
    expect_colour(s.shown, expected);
    EXPECT_EQ(s.shown.w, 3.5F);
    EXPECT_EQ(vec3(s.base), s.colour);
    EXPECT_EQ(vec3(s.shown_diffuse), s.diffuse);
    EXPECT_EQ(s.light, vec4(s.irradiance, s.openness));
    EXPECT_EQ(s.faults(), 0U);
}

TEST(StoreSamples, WithoutOcclusionThereIsNoAmbientLight) {
    Stored s;
    s.store<false>();
    dvec3 expected;
    for (int c = 0; c < 3; ++c)
        expected[c] = s.colour[c] + s.diffuse[c] * s.irradiance[c] / std::acos(-1.0);
    expect_colour(s.shown, expected);
    EXPECT_EQ(s.light, vec4(s.irradiance, s.openness));
}

TEST(StoreSamples, WithoutALightBufferAHitIsItsColour) {
    Stored s;
    s.flags = kSupportSample;
    s.store<false, false>();
    EXPECT_EQ(s.shown, vec4(s.colour, 3.5F));
    EXPECT_EQ(vec3(unpack_half4(s.support_colour[2 * kColumns + 3])), s.colour);
    EXPECT_EQ(s.support_light[2 * kColumns + 3].bits, kOld.bits);
}

TEST(StoreSamples, ASupportSampleIsFiledAtItsPlaceInTheGrid) {
    Stored s;
    s.flags = kSupportSample | kFovealSample;
    s.store();
    for (std::size_t i = 0; i < s.support_colour.size(); ++i) {
        if (i == 2 * kColumns + 3) continue;
        EXPECT_EQ(s.support_colour[i].bits, kOld.bits) << i;
        EXPECT_EQ(s.support_light[i].bits, kOld.bits) << i;
        EXPECT_EQ(s.support_depth_m[i], kOldDepth_m) << i;
    }
    EXPECT_EQ(vec3(unpack_half4(s.support_colour[2 * kColumns + 3])), vec3(s.shown));
    EXPECT_EQ(unpack_half4(s.support_light[2 * kColumns + 3]), s.light);
    EXPECT_EQ(s.support_depth_m[2 * kColumns + 3], 3.5F);
}

TEST(StoreSamples, OtherSamplesAreNotFiledInTheSupportImage) {
    Stored s;
    s.flags = static_cast<std::uint8_t>(~kSupportSample);
    s.store();
    for (std::size_t i = 0; i < s.support_colour.size(); ++i) {
        EXPECT_EQ(s.support_colour[i].bits, kOld.bits) << i;
        EXPECT_EQ(s.support_light[i].bits, kOld.bits) << i;
        EXPECT_EQ(s.support_depth_m[i], kOldDepth_m) << i;
    }
}

TEST(StoreSamples, SupportKeepsDepthsThatHalvesCannot) {
    Stored s;
    s.flags = kSupportSample;
    s.depth_m = 123456.789F;
    s.store();
    EXPECT_EQ(s.support_depth_m[2 * kColumns + 3], 123456.789F);
    EXPECT_EQ(s.shown.w, kInfinity);
}

TEST(StoreSamples, NanAndInfinityAreCountedAndBlack) {
    for (const float fault : {kNan, kInfinity}) {
        for (const bool in_light : {false, true}) {
            SCOPED_TRACE(testing::Message() << fault << (in_light ? " in light" : " in colour"));
            Stored s;
            s.flags = kSupportSample;
            (in_light ? s.irradiance : s.colour).y = fault;
            s.store();
            EXPECT_EQ(vec3(s.shown), vec3(0.0F));
            EXPECT_EQ(vec3(unpack_half4(s.support_colour[2 * kColumns + 3])), vec3(0.0F));
            EXPECT_EQ(s.counts.nan, std::isnan(fault) ? 1U : 0U);
            EXPECT_EQ(s.counts.inf, std::isnan(fault) ? 0U : 1U);
            EXPECT_EQ(s.counts.clamped, 0U);
            // What a later frame mixes in is black too.
            EXPECT_EQ(vec3(s.base), vec3(0.0F));
            EXPECT_EQ(vec3(s.light), vec3(0.0F));
            EXPECT_EQ(unpack_half4(s.support_light[2 * kColumns + 3]), s.light);
        }
    }
}

TEST(StoreSamples, AColourWhoseSumOverflowsIsTooBrightAndNotInfinite) {
    Stored s;
    s.colour = vec3(2.0e38F);
    s.store();
    EXPECT_EQ(s.counts.inf, 0U);
    EXPECT_EQ(s.counts.clamped, 1U);
    EXPECT_EQ(vec3(s.shown), vec3(kLargestHalf));
}

TEST(StoreSamples, TooBrightIsCountedAndHeldAtTheLargestHalf) {
    Stored s;
    s.flags = kSupportSample;
    s.colour = {1.0e5F, 0.25F, 0.5F};
    s.irradiance = {1.0F, 1.0e9F, 1.0F};
    s.store();
    EXPECT_EQ(s.counts.clamped, 1U);
    EXPECT_EQ(s.counts.nan + s.counts.inf, 0U);
    EXPECT_EQ(s.shown.x, kLargestHalf);
    EXPECT_EQ(s.shown.y, kLargestHalf);
    const double blue = 0.5 + 1.0 / std::acos(-1.0) + 0.875 * 0.75;
    EXPECT_NEAR(s.shown.z, blue, 1.0e-3);  // the others stay
    EXPECT_EQ(s.base.x, kLargestHalf);
    EXPECT_EQ(s.base.y, 0.25F);
    EXPECT_EQ(s.light.y, kLargestHalf);
    EXPECT_EQ(unpack_half4(s.support_light[2 * kColumns + 3]), s.light);
    EXPECT_EQ(vec3(unpack_half4(s.support_colour[2 * kColumns + 3])), vec3(s.shown));
}

TEST(StoreSamples, ABrightBackgroundIsHeldToo) {
    Stored s;
    s.slot = kMissed;
    s.background = vec3(7.0e4F, 1.0F, 2.0F);
    s.store();
    EXPECT_EQ(vec3(s.shown), vec3(kLargestHalf, 1.0F, 2.0F));
    EXPECT_EQ(vec3(s.base), vec3(kLargestHalf, 1.0F, 2.0F));
    EXPECT_EQ(s.counts.clamped, 1U);
}

}  // namespace
}  // namespace foverig
