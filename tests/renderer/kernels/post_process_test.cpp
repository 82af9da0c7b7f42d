#include "renderer/kernels/post_process.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace foverig {
namespace {

constexpr int kWidth = 61;  // cells of 7 or 8 pixels by 5 or 6: no multiple of either
constexpr int kHeight = 43;
constexpr int kColumns = 8;
constexpr int kRows = 8;

/// A coarse view over a small image, and what the post-process reads and writes there.
struct Scene {
    std::vector<std::uint8_t> marked = std::vector<std::uint8_t>(kColumns * kRows, 0);
    std::vector<float> inverse_depth = std::vector<float>(kColumns * kRows, 0.5F);
    std::vector<std::int16_t> column_of, row_of, column_from_px, row_from_px;
    std::vector<Half4> colour{kWidth * kHeight}, light{kWidth * kHeight};
    std::vector<CacheInfo> info{kWidth * kHeight};

    Scene() {
        const auto axis = [](int size_px, int cells, auto& of, auto& from) {
            for (int p = 0; p < size_px; ++p) {
                of.push_back(static_cast<std::int16_t>(p * cells / size_px));
                if (p == 0 || of[of.size() - 2] != of.back())
                    from.push_back(static_cast<std::int16_t>(p));
            }
            from.push_back(static_cast<std::int16_t>(size_px));
        };
        axis(kWidth, kColumns, column_of, column_from_px);
        axis(kHeight, kRows, row_of, row_from_px);
        std::fill(light.begin(), light.end(), pack_half4({0.5F, 0.0F, 0.0F, 0.5F}));
    }
    CoarseLookup lookup() const {
        return {marked.data(),      column_of.data(), row_of.data(), column_from_px.data(),
                row_from_px.data(), kColumns,         kRows};
    }
    bool reconstructed(int x, int y) const {
        return x >= 0 && y >= 0 && x < kWidth && y < kHeight && !lookup()(x, y);
    }
    /// Marks one cell; returns its upper left pixel, beside a reconstructed one.
    std::pair<int, int> mark_one() {
        marked[3 * kColumns + 4] = 1;
        return {column_from_px[4], row_from_px[3]};
    }
    /// One diffuse white sample at (x, y), 2 m away, with that much red irradiance of its own, half
    /// the directions open. Returns irradiance and openness that it ends with.
    std::pair<float, float> light_of(int x, int y, std::uint8_t flags, float own) {
        PackedPixel pixel =
            pack_pixel(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
        Half4 traced = pack_half4({0.0F, 0.0F, 0.0F, 2.0F});
        Half4 base = pack_half4({0.0F, 0.0F, 0.0F, 0.0F});
        Half4 diffuse = pack_half4({1.0F, 1.0F, 1.0F, 0.0F});
        Half4 own_light = pack_half4({own, 0.0F, 0.0F, 0.5F});
        const Samples samples{&pixel, &flags, &traced, &base, &diffuse, &own_light};
        const HistoryImages images{colour.data(), info.data(), light.data()};
        const auto at = static_cast<std::size_t>(y * kWidth + x);
        colour[at] = pack_half4({-1.0F, -1.0F, -1.0F, 0.75F});
        const float noise = 0.5F / std::sqrt(16.0F);
        const vec3 blue_ambient(0.0F, 0.0F, 1.0F);
        PostProcess<true>{samples, images, lookup(), inverse_depth.data(),
                          0.05F,   noise,  noise,    blue_ambient,
                          8,       16,     1U,       kWidth,
                          kHeight}(0);
        const vec4 shown = unpack_half4(colour[at]);
        EXPECT_EQ(shown.w, 0.75F);  // the cache's weight stays
        return {shown.x / kInversePi, shown.z};
    }
};

constexpr std::pair<float, float> kUntouched{-1.0F / kInversePi, -1.0F};

TEST(PostProcess, WindowIsTheDistanceFoundPixelByPixel) {
    std::uint32_t h = 1;
    for (int round = 0; round < 40; ++round) {
        Scene scene;
        for (std::uint8_t& m : scene.marked) {
            h = hash32(h);
            m = h % 40U > static_cast<std::uint32_t>(round) ? 1 : 0;
        }
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                if (scene.reconstructed(x, y)) continue;
                int wanted = 0;
                for (int d = 16; d >= 1; --d)
                    if (scene.reconstructed(x - d, y) || scene.reconstructed(x + d, y) ||
                        scene.reconstructed(x, y - d) || scene.reconstructed(x, y + d))
                        wanted = d;
                ASSERT_EQ(scene.lookup().distance_to_unmarked(x, y, 16), wanted)
                    << x << ", " << y << " of round " << round;
            }
    }
}

TEST(PostProcess, TakesTheLightOfTheClosestReconstructedPixel) {
    Scene scene;
    const auto [x, y] = scene.mark_one();
    scene.light[static_cast<std::size_t>(y * kWidth + x - 1)] = pack_half4({0.25F, 0, 0, 0.5625F});
    const auto [irradiance, openness] = scene.light_of(x, y, kResampled, 0.245F);
    EXPECT_NEAR(irradiance, 0.25F, 1.0e-3F);
    EXPECT_NEAR(openness, 0.5625F, 1.0e-3F);
}

// By hand: v = 0.5 / 0.75 or 0.5; half of sqrt(v (1 - v) / 16) of the larger one.
TEST(PostProcess, MovesNoFurtherThanLightNoiseExplains) {
    Scene scene;
    const auto [x, y] = scene.mark_one();
    scene.light[static_cast<std::size_t>(y * kWidth + x - 1)] = pack_half4({0.75F, 0, 0, 1.0F});
    const auto [irradiance, openness] = scene.light_of(x, y, kResampled, 0.5F);
    // Luminances are 0.2126 of the red, which cancels out of everything but the share.
    EXPECT_NEAR(irradiance, 0.5F + 0.125F * 0.75F * std::sqrt(2.0F) / 3.0F, 2.0e-3F);
    EXPECT_NEAR(openness, 0.5F + 0.125F * 0.5F, 2.0e-3F);
    EXPECT_NEAR(scene.light_of(x, y, kResampled, 0.0F).first, 0.0F, 1.0e-3F);  // in full shadow
}

TEST(PostProcess, TakesNothingFromAnotherSurface) {
    Scene scene;
    const auto [x, y] = scene.mark_one();
    std::fill(scene.inverse_depth.begin(), scene.inverse_depth.end(), 1.0F / 2.2F);
    EXPECT_EQ(scene.light_of(x, y, kResampled, 0.49F), kUntouched);
    std::fill(scene.inverse_depth.begin(), scene.inverse_depth.end(), 0.0F);  // sky
    EXPECT_EQ(scene.light_of(x, y, kResampled, 0.49F), kUntouched);
    std::fill(scene.inverse_depth.begin(), scene.inverse_depth.end(), 1.0F / 2.05F);
    EXPECT_NE(scene.light_of(x, y, kResampled, 0.49F), kUntouched);
}

TEST(PostProcess, LeavesTheFoveaAndWhatWasNotResampled) {
    Scene scene;
    const auto [x, y] = scene.mark_one();
    EXPECT_EQ(scene.light_of(x, y, kResampled | kFovealSample, 0.49F), kUntouched);
    EXPECT_EQ(scene.light_of(x, y, 0, 0.49F), kUntouched);
}

TEST(PostProcess, LeavesAPixelWithNothingReconstructedInReach) {
    Scene scene;
    std::fill(scene.marked.begin(), scene.marked.end(), std::uint8_t{1});
    EXPECT_EQ(scene.light_of(30, 20, kResampled, 0.49F), kUntouched);
}

}  // namespace
}  // namespace foverig
