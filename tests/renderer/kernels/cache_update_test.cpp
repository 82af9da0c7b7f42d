#include "renderer/kernels/cache_update.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/renderer/kernels/mesh_arrays.h"

namespace foverig {
namespace {

constexpr int kWidth = 100;
constexpr int kHeight = 70;
constexpr int kX0 = 64;  // a tile clipped by the image on both sides
constexpr int kY0 = 64;
constexpr int kX = 71;
constexpr int kY = 66;
constexpr std::size_t kAt = kY * kWidth + kX;
constexpr double kHalfStep = 0x1.0p-11;  // what rounding to a half may change, relative
constexpr float kEpsilon = 0.05F;
constexpr std::uint64_t kSentinel = 0x1234567890ABCDEFULL;

constexpr double kMin = 0.1;
constexpr double kMinLight = 0.02;
constexpr double kMax = 0.75;
constexpr int kLongest = 30;  // t_max, frames

/// Weier 2016 3.4 in double, with the maximum that its words ask for.
double weight(double rho, double age, double k_min) {
    const double x0 = std::log(k_min);
    const double x1 = std::log(kMax);
    const double k = std::min(std::exp(x0 + (age - 1.0) / (kLongest - 1.0) * (x1 - x0)), kMax);
    return std::max(1.0 / (rho + 1.0), k);
}

/// One pixel as it was reprojected, and one sample there.
struct OnePixel {
    vec4 cached{0.25F, 0.5F, 0.75F, 4.0F};  // w = rho
    vec4 cached_light{0.5F, 1.0F, 1.5F, 0.25F};
    std::uint32_t touched = 100;
    std::uint32_t frame = 103;
    float cache_depth_m = 2.0F;                  // 0: not covered
    vec4 sample{0.875F, 0.125F, 0.0625F, 2.0F};  // w = depth
    vec3 base{0.125F, 0.25F, 0.5F};
    vec3 diffuse{0.5F, 0.75F, 1.0F};
    vec4 light{2.0F, 0.25F, 3.0F, 0.75F};
    vec3 ambient{0.375F, 0.625F, 0.875F};
    std::uint8_t flags = kChosenSample;

    vec4 shown{};  ///< what the update made of them
    vec4 shown_light{};
    CacheInfo info = 0;

    template <bool kOcclusion = true, bool kLightBuffer = true, bool kOversampling = false>
    OnePixel& update() {
        std::vector<Half4> colours(kWidth * kHeight, {kSentinel});
        std::vector<Half4> lights(kWidth * kHeight, {kSentinel});
        std::vector<CacheInfo> infos(kWidth * kHeight, 0xBEEFU);
        colours[kAt] = pack_half4(cached);
        lights[kAt] = pack_half4(cached_light);
        infos[kAt] = touched_in(touched);
        RasterArrays raster;
        if (cache_depth_m > 0.0F)
            raster.inverse_depth[RasterArrays::index(kX - kX0, kY - kY0)] = 1.0F / cache_depth_m;
        PackedPixel pixel = pack_pixel(kX, kY);
        Half4 packed[4] = {pack_half4(sample), pack_half4(vec4(base, 0.0F)),
                           pack_half4(vec4(diffuse, 0.0F)), pack_half4(light)};
        const Samples samples{&pixel, &flags, &packed[0], &packed[1], &packed[2], &packed[3]};
        CacheUpdate<kOcclusion, kLightBuffer, kOversampling>{
            raster.tile(),
            samples,
            {colours.data(), infos.data(), kLightBuffer ? lights.data() : nullptr},
            SmallestWeight(kMin, kMax, kLongest),
            SmallestWeight(kMinLight, kMax, kLongest),
            ambient,
            kEpsilon,
            frame,
            kX0,
            kY0,
            kWidth}(0);
        shown = unpack_half4(colours[kAt]);
        shown_light = unpack_half4(lights[kAt]);
        info = infos[kAt];
        for (std::size_t i = 0; i < colours.size(); ++i) {
            if (i == kAt) continue;
            EXPECT_EQ(colours[i].bits, kSentinel) << i;
            EXPECT_EQ(lights[i].bits, kSentinel) << i;
            EXPECT_EQ(infos[i], 0xBEEFU) << i;
        }
        return *this;
    }
    bool replaced() const { return vec3(shown) == vec3(sample) && shown.w == 1.0F; }
};

void expect_half(double value, double expected) {
    EXPECT_NEAR(value, expected, 1.1 * kHalfStep * std::abs(expected) + 1.0e-6);
}

void expect_blended(const OnePixel& p, double alpha) {
    for (int c = 0; c < 3; ++c)
        expect_half(p.shown[c], alpha * p.sample[c] + (1.0 - alpha) * p.cached[c]);
    expect_half(p.shown.w, 1.0 / (alpha * alpha + (1.0 - alpha) * (1.0 - alpha) / p.cached.w));
    EXPECT_EQ(p.info, p.frame & 0xFFFFU);
}

TEST(CacheUpdate, BlendsWithTheWeightThatCountAndAgeGive) {
    for (const float rho : {0.5F, 1.0F, 2.0F, 5.0F, 19.0F, 256.0F})
        for (const std::uint32_t age : {1U, 2U, 7U, 29U, 30U, 31U, 500U}) {
            SCOPED_TRACE(testing::Message() << "rho " << rho << ", age " << age);
            OnePixel p;
            p.cached.w = rho;
            p.frame = p.touched + age;
            expect_blended(p.update<false, false>(), weight(rho, age, kMin));
        }
}

TEST(CacheUpdate, CountsAgeAcrossTheWrapOfTheSixteenBitFrame) {
    for (const std::uint32_t touched : {0xFFF0U, 0xFFFFU, 0x1FFF8U, 0xFFFFFFFFU})
        for (const std::uint32_t age : {1U, 3U, 17U, 29U}) {
            SCOPED_TRACE(testing::Message() << "touched in " << touched << ", age " << age);
            OnePixel p;
            p.cached.w = 256.0F;  // so that age alone decides
            p.touched = touched;
            p.frame = touched + age;
            expect_blended(p.update<false, false>(), weight(256.0, age, kMin));
        }
}

TEST(CacheUpdate, FovealAndResampledSamplesReplace) {
    for (const std::uint8_t why : {kFovealSample, kResampled}) {
        OnePixel p;
        p.flags = static_cast<std::uint8_t>(why | kChosenSample | kSupportSample);
        p.update();
        EXPECT_TRUE(p.replaced()) << int{why};
        EXPECT_EQ(p.shown_light, p.light);
        EXPECT_EQ(p.info, p.frame);
    }
}

TEST(CacheUpdate, DrawnAndSupportSamplesBlend) {
    for (const std::uint8_t why : {kChosenSample, kSupportSample}) {
        OnePixel p;
        p.flags = why;
        expect_blended(p.update<false, false>(), weight(p.cached.w, 3.0, kMin));
    }
}

TEST(CacheUpdate, OversamplingAccumulatesFovealAndResampledSamples) {
    for (const std::uint8_t why : {kFovealSample, kResampled}) {
        OnePixel p;
        p.flags = why;
        p.update<false, false, true>();
        expect_blended(p, weight(p.cached.w, 3.0, kMin));
        p.cache_depth_m = 3.0F;  // but not over another surface
        EXPECT_TRUE((p.update<false, false, true>().replaced()));
    }
}

TEST(CacheUpdate, UncoveredPixelsTakeTheSampleAlone) {
    OnePixel p;
    p.cache_depth_m = 0.0F;
    EXPECT_TRUE(p.update().replaced());
    EXPECT_EQ(p.shown_light, p.light);
    p.sample.w = std::numeric_limits<float>::infinity();  // far is not uncovered
    EXPECT_TRUE(p.update().replaced());
}

TEST(CacheUpdate, ReplacesWhereDepthsDifferByMoreThanAShareOfTheSamples) {
    for (const float sample_m : {0.25F, 1.0F, 4.0F, 16.0F})
        for (const double share : {-0.5, -0.0512, -0.0488, 0.0, 0.0488, 0.0512, 0.5}) {
            OnePixel p;
            p.sample.w = sample_m;
            p.cache_depth_m = static_cast<float>(sample_m * (1.0 + share));
            p.update<false, false>();
            EXPECT_EQ(p.replaced(), std::abs(share) > kEpsilon) << sample_m << " m, " << share;
        }
}

TEST(CacheUpdate, DepthsBeyondHalfsRangeAreEquallyFar) {
    const float infinity = std::numeric_limits<float>::infinity();
    OnePixel p;
    p.sample.w = infinity;
    for (const float cache_m : {1.0e5F, 1.0e6F, 1.0e7F}) {
        p.cache_depth_m = cache_m;
        EXPECT_FALSE((p.update<false, false>().replaced())) << cache_m;
    }
    for (const float cache_m : {2.0F, 500.0F, 5000.0F}) {
        p.cache_depth_m = cache_m;
        EXPECT_TRUE((p.update<false, false>().replaced())) << cache_m;
    }
    p.cache_depth_m = 1.0e6F;
    p.sample.w = 500.0F;
    EXPECT_TRUE((p.update<false, false>().replaced()));
}

TEST(CacheUpdate, LightHasItsOwnRate) {
    for (const float rho : {0.5F, 4.0F, 20.0F, 256.0F})
        for (const std::uint32_t age : {1U, 10U, 29U, 90U}) {
            SCOPED_TRACE(testing::Message() << "rho " << rho << ", age " << age);
            OnePixel p;
            p.cached.w = rho;
            p.frame = p.touched + age;
            p.update();
            const double alpha = weight(rho, age, kMin);
            const double light_alpha = weight(rho, age, kMinLight);
            double light[4];
            for (int c = 0; c < 4; ++c) {
                light[c] = light_alpha * p.light[c] + (1.0 - light_alpha) * p.cached_light[c];
                expect_half(p.shown_light[c], light[c]);
            }
            for (int c = 0; c < 3; ++c) {
                const double lit_now = p.base[c] + p.diffuse[c] * (light[c] / std::acos(-1.0) +
                                                                   p.ambient[c] * light[3]);
                expect_half(p.shown[c], alpha * lit_now + (1.0 - alpha) * p.cached[c]);
            }
            expect_half(p.shown.w, 1.0 / (alpha * alpha + (1.0 - alpha) * (1.0 - alpha) / rho));
        }
}

TEST(CacheUpdate, AmbientLightNeedsOcclusion) {
    OnePixel p;
    p.cached.w = 0.0F;
    p.update<false>();
    for (int c = 0; c < 3; ++c)
        expect_half(p.shown[c], p.base[c] + p.diffuse[c] * p.light[c] / std::acos(-1.0));
}

TEST(CacheUpdate, APixelNeverSampledTakesItsFirstSampleAlone) {
    OnePixel p;
    p.cached = {kLargestHalf, kLargestHalf, kLargestHalf, 0.0F};
    p.cached_light = vec4(kLargestHalf);
    EXPECT_TRUE((p.update<false, false>().replaced()));
    p.update();
    EXPECT_EQ(p.shown_light, p.light);
    EXPECT_EQ(p.shown.w, 1.0F);
    for (int c = 0; c < 3; ++c)
        expect_half(p.shown[c], p.base[c] + p.diffuse[c] * (p.light[c] / std::acos(-1.0) +
                                                            p.ambient[c] * p.light.w));
}

TEST(CacheUpdate, TheBrightestColourAHalfHoldsStaysFinite) {
    for (const float rho : {0.0F, 0.25F, 1.0F, 7.0F, 39.0F})
        for (const std::uint32_t age : {1U, 8U, 40U}) {
            OnePixel p;
            p.frame = p.touched + age;
            p.cached = {kLargestHalf, kLargestHalf, 0.0F, rho};
            p.sample = {kLargestHalf, kLargestHalf, kLargestHalf, 2.0F};
            p.base = vec3(kLargestHalf);
            p.diffuse = vec3(1.0F);
            p.light = p.cached_light = {kLargestHalf, kLargestHalf, kLargestHalf, 1.0F};
            for (const bool with_light : {false, true}) {
                if (with_light)
                    p.update();
                else
                    p.update<false, false>();
                const double alpha = weight(rho, age, kMin);
                EXPECT_EQ(p.shown.x, kLargestHalf) << rho << ", age " << age;
                EXPECT_EQ(p.shown.y, kLargestHalf) << rho << ", age " << age;
                expect_half(p.shown.z, alpha * kLargestHalf);
            }
            EXPECT_EQ(vec3(p.shown_light), vec3(kLargestHalf));
        }
}

TEST(CacheUpdate, EachSampleMeetsItsOwnPixel) {
    // Every pixel of a clipped tile, in an order of its own; every third is uncovered.
    constexpr int kTileWidth = kWidth - kX0;
    constexpr int kSamples = kTileWidth * (kHeight - kY0);
    std::vector<PackedPixel> pixels(kSamples);
    std::vector<std::uint8_t> flags(kSamples, kChosenSample);
    std::vector<Half4> traced(kSamples);
    std::vector<Half4> colours(kWidth * kHeight, pack_half4({4.0F, 0.0F, 0.0F, 1.0F}));
    std::vector<CacheInfo> infos(kWidth * kHeight, touched_in(6U));
    RasterArrays raster;
    const auto place = [](int i) { return i * 5 % kSamples; };  // 5 and 216 have no common factor
    for (int i = 0; i < kSamples; ++i) {
        const int x = place(i) % kTileWidth;
        const int y = place(i) / kTileWidth;
        pixels[static_cast<std::size_t>(i)] = pack_pixel(kX0 + x, kY0 + y);
        traced[static_cast<std::size_t>(i)] =
            pack_half4({0.0F, static_cast<float>(place(i)), 0.0F, 2.0F});
        raster.inverse_depth[RasterArrays::index(x, y)] = place(i) % 3 == 0 ? 0.0F : 0.5F;
    }
    const CacheUpdate<false, false, false> update{raster.tile(),
                                                  {pixels.data(), flags.data(), traced.data()},
                                                  {colours.data(), infos.data()},
                                                  SmallestWeight(kMin, kMax, kLongest),
                                                  {},
                                                  vec3(0.0F),
                                                  kEpsilon,
                                                  7U,
                                                  kX0,
                                                  kY0,
                                                  kWidth};
    for (int i = 0; i < kSamples; ++i) update(i);
    for (int i = 0; i < kSamples; ++i) {
        const int x = kX0 + i % kTileWidth;
        const int y = kY0 + i / kTileWidth;
        const vec4 shown = unpack_half4(colours[static_cast<std::size_t>(y * kWidth + x)]);
        const float n = static_cast<float>(i);
        EXPECT_EQ(shown, i % 3 == 0 ? vec4(0.0F, n, 0.0F, 1.0F) : vec4(2.0F, n / 2.0F, 0.0F, 2.0F))
            << x << ", " << y;
    }
}

}  // namespace
}  // namespace foverig
