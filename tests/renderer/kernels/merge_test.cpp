#include "renderer/kernels/merge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/renderer/kernels/mesh_arrays.h"

namespace foverig {
namespace {

constexpr int kWidth = 91;   // 90 = 9 cells of 10 pixels
constexpr int kHeight = 71;  // 70 = 10 cells of 7 pixels
constexpr int kColumns = 10;
constexpr int kRows = 11;
constexpr int kX0 = 64;
constexpr int kY0 = 64;
constexpr std::uint32_t kFrame = 0x12345U;
constexpr Half4 kOld{0x1234567890ABCDEFULL};
constexpr CacheInfo kOldInfo = 0xBEEFU;
constexpr float kHalfStep = 0x1.0p-11F;

/// One tile of an image, merged over with a support image of the same linear ramps.
struct Merged {
    RasterArrays raster;
    std::vector<Half4> colour = std::vector<Half4>(kWidth * kHeight, kOld);
    std::vector<Half4> light = std::vector<Half4>(kWidth * kHeight, kOld);
    std::vector<CacheInfo> info = std::vector<CacheInfo>(kWidth * kHeight, kOldInfo);
    std::vector<Half4> support_colour{kColumns * kRows};
    std::vector<Half4> support_light{kColumns * kRows};

    /// At pixel (x, y), whole or not; w is what a support sample does not hold.
    static vec4 colour_ramp(float x, float y) {
        return {1.0F + x / 16.0F, 9.0F - y / 16.0F, (x + y) / 32.0F, 5.0F};
    }
    static vec4 light_ramp(float x, float y) {
        return {8.0F - x / 16.0F, y / 8.0F, 2.0F, 0.25F + x / 256.0F};
    }
    Merged() {
        for (int row = 0; row < kRows; ++row)
            for (int column = 0; column < kColumns; ++column) {
                const auto i = static_cast<std::size_t>(row * kColumns + column);
                const auto x = static_cast<float>(10 * column);
                const auto y = static_cast<float>(7 * row);
                support_colour[i] = pack_half4(colour_ramp(x, y));
                support_light[i] = pack_half4(light_ramp(x, y));
            }
    }
    template <bool kLightBuffer>
    void merge(int x0, int y0, int width, int height) {
        const SupportImages support{support_colour.data(), support_light.data(), nullptr, kColumns,
                                    kRows};
        const MergeSupport<kLightBuffer> kernel{
            raster.tile(),
            {support, static_cast<float>(kColumns - 1) / static_cast<float>(kWidth - 1),
             static_cast<float>(kRows - 1) / static_cast<float>(kHeight - 1)},
            {colour.data(), info.data(), kLightBuffer ? light.data() : nullptr},
            x0,
            y0,
            width,
            kWidth,
            kFrame};
        for (int y = 0; y < height; ++y) kernel(y);
    }
    void merge_all() {
        merge<true>(0, 0, 64, 64);
        merge<true>(kX0, 0, kWidth - kX0, 64);
        merge<true>(0, kY0, 64, kHeight - kY0);
        merge<true>(kX0, kY0, kWidth - kX0, kHeight - kY0);
    }
    static std::size_t at(int x, int y) { return static_cast<std::size_t>(y * kWidth + x); }
};

void expect_near(const vec4& value, const vec4& expected, int x, int y) {
    for (int c = 0; c < 4; ++c)
        EXPECT_NEAR(value[c], expected[c], 2.0F * kHalfStep * expected[c] + 1.0e-5F)
            << "channel " << c << " at " << x << ", " << y;
}

TEST(MergeSupport, FillsHolesWithTheLinearRampThatTheSupportSampled) {
    Merged m;
    m.merge_all();
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const auto fx = static_cast<float>(x);
            const auto fy = static_cast<float>(y);
            expect_near(unpack_half4(m.colour[Merged::at(x, y)]),
                        vec4(vec3(Merged::colour_ramp(fx, fy)), 0.0F), x, y);
            expect_near(unpack_half4(m.light[Merged::at(x, y)]), Merged::light_ramp(fx, fy), x, y);
        }
}

TEST(MergeSupport, IsBilinearBetweenFourSamples) {
    // One bright sample: a tent, (1 - |dx| / 10) (1 - |dy| / 7), by hand.
    Merged m;
    for (Half4& s : m.support_colour) s = pack_half4(vec4(0.0F));
    m.support_colour[4 * kColumns + 3] = pack_half4({1024.0F, 0.0F, 0.0F, 0.0F});
    m.merge_all();
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const double dx = std::max(0.0, 1.0 - std::abs(x - 30) / 10.0);
            const double dy = std::max(0.0, 1.0 - std::abs(y - 28) / 7.0);
            EXPECT_NEAR(unpack_half4(m.colour[Merged::at(x, y)]).x, 1024.0 * dx * dy,
                        1024.0 * kHalfStep)
                << x << ", " << y;
        }
}

TEST(MergeSupport, APixelNeverSampledHasNoCountAndNoWeight) {
    Merged m;
    m.merge_all();
    for (std::size_t i = 0; i < m.info.size(); ++i) {
        EXPECT_EQ(unpack_half4(m.colour[i]).w, 0.0F);
        EXPECT_EQ(m.info[i], kFrame & 0xFFFFU);
    }
}

TEST(MergeSupport, LeavesCoveredPixelsAndOtherTilesAsTheyAre) {
    Merged m;
    const auto covered = [](int x, int y) { return (x * 7 + y * 3) % 5 < 2; };
    for (int y = kY0; y < kHeight; ++y)
        for (int x = kX0; x < kWidth; ++x)
            if (covered(x, y))  // even as far away as it gets
                m.raster.inverse_depth[RasterArrays::index(x - kX0, y - kY0)] = 1.0e-30F;
    m.merge<true>(kX0, kY0, kWidth - kX0, kHeight - kY0);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const std::size_t i = Merged::at(x, y);
            const bool kept = x < kX0 || y < kY0 || covered(x, y);
            EXPECT_EQ(m.colour[i].bits == kOld.bits, kept) << x << ", " << y;
            EXPECT_EQ(m.light[i].bits == kOld.bits, kept) << x << ", " << y;
            EXPECT_EQ(m.info[i] == kOldInfo, kept) << x << ", " << y;
        }
}

TEST(MergeSupport, WithoutALightBufferColourIsTheSame) {
    Merged with;
    Merged without;
    with.merge<true>(kX0, kY0, kWidth - kX0, kHeight - kY0);
    without.merge<false>(kX0, kY0, kWidth - kX0, kHeight - kY0);
    for (std::size_t i = 0; i < with.colour.size(); ++i) {
        EXPECT_EQ(with.colour[i].bits, without.colour[i].bits);
        EXPECT_EQ(without.light[i].bits, kOld.bits);
    }
}

TEST(MergeSupport, SmallestSupportImageReachesFromCornerToCorner) {
    RasterArrays raster;
    std::vector<Half4> colour(25);
    std::vector<CacheInfo> info(25);
    Half4 corners[4];
    for (int i = 0; i < 4; ++i) {  // 0 4 / 8 12: the ramp x + 2 y over 5x5 pixels
        const auto value = static_cast<float>(4 * i);
        corners[i] = pack_half4({value, value, value, 0.0F});
    }
    const SupportLookup lookup{{corners, nullptr, nullptr, 2, 2}, 0.25F, 0.25F};
    for (int y = 0; y < 5; ++y)
        MergeSupport<false>{raster.tile(), lookup, {colour.data(), info.data()}, 0, 0, 5, 5, 1U}(y);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 5; ++x)
            EXPECT_EQ(unpack_half4(colour[static_cast<std::size_t>(y * 5 + x)]).x,
                      static_cast<float>(x + 2 * y))
                << x << ", " << y;
}

}  // namespace
}  // namespace foverig
