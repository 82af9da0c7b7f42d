#include "renderer/kernels/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "tests/renderer/chi_square.h"

namespace foverig {
namespace {

/// Whether 2^log2_n points starting at `first` hold each elementary interval 2^-a x 2^-(log2_n - a)
/// exactly once.
bool is_net(std::uint32_t first, int log2_n, std::uint32_t seed) {
    const std::uint32_t n = 1U << log2_n;
    for (int a = 0; a <= log2_n; ++a) {
        std::set<std::uint32_t> boxes;
        for (std::uint32_t i = first; i < first + n; ++i) {
            const vec2 p = scrambled_point(i, seed);
            const auto column = static_cast<std::uint32_t>(std::ldexp(static_cast<double>(p.x), a));
            const auto row =
                static_cast<std::uint32_t>(std::ldexp(static_cast<double>(p.y), log2_n - a));
            boxes.insert((column << (log2_n - a)) | row);
        }
        if (boxes.size() != n) return false;
    }
    return true;
}

TEST(ScrambledPoint, EachPatternsRunOfSixteenIsANet) {
    for (const std::uint32_t seed : {0U, 1U, 0xDEADBEEFU, 0x12345678U})
        for (std::uint32_t pattern = 0; pattern < kPatterns; ++pattern)
            EXPECT_TRUE(is_net(16 * pattern, 4, seed)) << pattern << ' ' << seed;
}

TEST(ScrambledPoint, AllPatternsTogetherAreANetOf256) {
    for (const std::uint32_t seed : {0U, 1U, 0xDEADBEEFU, 0x12345678U})
        EXPECT_TRUE(is_net(0, 8, seed)) << seed;
}

TEST(ScrambledPoint, ARunOffTheGridIsNoNet) {
    bool all = true;
    for (std::uint32_t first = 1; first < 16; ++first) all = all && is_net(first, 4, 7U);
    EXPECT_FALSE(all);
}

TEST(ScrambledPoint, StaysBelowOneWhateverTheScramble) {
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        for (const std::uint32_t i : {0U, 0xFFFFFFFFU, seed}) {
            const vec2 p = scrambled_point(i, seed);
            ASSERT_TRUE(p.x >= 0.0F && p.x < 1.0F && p.y >= 0.0F && p.y < 1.0F);
        }
    }
}

TEST(ReverseBits, MirrorsEveryBit) {
    for (int bit = 0; bit < 32; ++bit) EXPECT_EQ(reverse_bits(1U << bit), 1U << (31 - bit));
    EXPECT_EQ(reverse_bits(0x0000FFFFU), 0xFFFF0000U);
}

TEST(Hash32, IsABijectionOnARange) {
    std::set<std::uint32_t> seen;
    for (std::uint32_t i = 0; i < 100000; ++i) seen.insert(hash32(i));
    EXPECT_EQ(seen.size(), 100000U);
}

TEST(Hash32, OfCountersIsUniform) {
    constexpr int kBins = 256;
    constexpr std::uint32_t kDraws = 256 * 400;
    std::vector<double> high(kBins);
    std::vector<double> low(kBins);
    for (std::uint32_t i = 0; i < kDraws; ++i) {
        ++high[hash32(i) >> 24U];
        ++low[hash32(i) & 255U];
    }
    const std::vector<double> expected(kBins, 400.0);
    EXPECT_LT(chi_square(high, expected), chi_square_bound(kBins - 1));
    EXPECT_LT(chi_square(low, expected), chi_square_bound(kBins - 1));
}

TEST(Hash32, OfPairsIsUniformAndItsDimensionsIndependent) {
    constexpr int kSide = 16;
    constexpr std::uint32_t kGrid = 320;
    std::vector<double> counts(kSide * kSide);
    for (std::uint32_t a = 0; a < kGrid; ++a)
        for (std::uint32_t b = 0; b < kGrid; ++b)
            ++counts[(hash32(a, b) >> 28U) * kSide + (hash32(a, b + 1) >> 28U)];
    const std::vector<double> expected(kSide * kSide,
                                       static_cast<double>(kGrid) * kGrid / (kSide * kSide));
    EXPECT_LT(chi_square(counts, expected), chi_square_bound(kSide * kSide - 1));
}

TEST(UnitFloat, CoversTheUnitIntervalWithoutOne) {
    EXPECT_EQ(unit_float(0U), 0.0F);
    EXPECT_EQ(unit_float(0xFFFFFFFFU), 1.0F - 0x1.0p-24F);
    EXPECT_EQ(unit_float(0x80000000U), 0.5F);
}

TEST(CosineDirection, IsUnitAndAboveTheSurface) {
    for (std::uint32_t i = 0; i < 4096; ++i) {
        const vec3 d = cosine_direction(scrambled_point(i, 3U));
        ASSERT_NEAR(glm::length(dvec3(d)), 1.0, 1.0e-6);
        ASSERT_GE(d.z, 0.0F);
    }
}

TEST(CosineDirection, HasTheMeanOfTheCosineLobe) {
    dvec3 mean(0.0);
    constexpr std::uint32_t kDraws = 1U << 16U;
    for (std::uint32_t i = 0; i < kDraws; ++i)
        mean += dvec3(cosine_direction(scrambled_point(i, 11U)));
    mean /= kDraws;
    EXPECT_NEAR(mean.x, 0.0, 1.0e-4);
    EXPECT_NEAR(mean.y, 0.0, 1.0e-4);
    EXPECT_NEAR(mean.z, 2.0 / 3.0, 1.0e-4);
}

TEST(CosineDirection, HasDensityCosineOverPi) {
    // Bands of the cosine c and of azimuth: the lobe puts (c1^2 - c0^2) da / 2 pi into one.
    constexpr int kBands = 12;
    constexpr int kAzimuths = 12;
    constexpr std::uint32_t kDraws = 200000;
    std::vector<double> counts(kBands * kAzimuths);
    std::vector<double> expected(counts.size());
    for (int band = 0; band < kBands; ++band)
        for (int azimuth = 0; azimuth < kAzimuths; ++azimuth)
            expected[static_cast<std::size_t>(band * kAzimuths + azimuth)] =
                kDraws * (2.0 * band + 1.0) / (kBands * kBands) / kAzimuths;
    for (std::uint32_t i = 0; i < kDraws; ++i) {
        const vec3 d = cosine_direction({unit_float(hash32(i, 1U)), unit_float(hash32(i, 2U))});
        const double turn = std::atan2(static_cast<double>(d.y), static_cast<double>(d.x)) /
                            (2.0 * std::numbers::pi);
        const int band = std::min(static_cast<int>(d.z * kBands), kBands - 1);
        const int azimuth =
            std::min(static_cast<int>((turn < 0.0 ? turn + 1.0 : turn) * kAzimuths), kAzimuths - 1);
        ++counts[static_cast<std::size_t>(band * kAzimuths + azimuth)];
    }
    EXPECT_LT(chi_square(counts, expected), chi_square_bound(kBands * kAzimuths - 1));
}

void expect_orthonormal(const vec3& n) {
    const Frame f = frame_about(n);
    const dvec3 t(f.tangent);
    const dvec3 b(f.bitangent);
    const dvec3 d(n);
    EXPECT_EQ(f.normal, n);
    EXPECT_NEAR(glm::length(t), 1.0, 1.0e-6);
    EXPECT_NEAR(glm::length(b), 1.0, 1.0e-6);
    EXPECT_NEAR(glm::dot(t, d), 0.0, 1.0e-6);
    EXPECT_NEAR(glm::dot(b, d), 0.0, 1.0e-6);
    EXPECT_NEAR(glm::dot(t, b), 0.0, 1.0e-6);
    EXPECT_NEAR(glm::dot(glm::cross(t, b), d), 1.0, 3.0e-6);
}

TEST(FrameAbout, IsOrthonormalAndRightHandedEverywhere) {
    for (std::uint32_t i = 0; i < 2000; ++i) {
        const double z = 2.0 * static_cast<double>(unit_float(hash32(i, 5U))) - 1.0;
        const double phi = 2.0 * std::numbers::pi * static_cast<double>(unit_float(hash32(i, 6U)));
        const double r = std::sqrt(1.0 - z * z);
        expect_orthonormal(vec3(dvec3(r * std::cos(phi), r * std::sin(phi), z)));
    }
}

TEST(FrameAbout, HoldsAtThePolesAndOnTheEquator) {
    expect_orthonormal({0.0F, 0.0F, 1.0F});
    expect_orthonormal({0.0F, 0.0F, -1.0F});
    expect_orthonormal({1.0F, 0.0F, -0.0F});
    expect_orthonormal({0.0F, -1.0F, 0.0F});
    for (const double tilt : {1.0e-1, 1.0e-2, 1.0e-3, 1.0e-4, 1.0e-6, 1.0e-9, 1.0e-20})
        expect_orthonormal(
            vec3(dvec3(std::sin(tilt) * 0.6, std::sin(tilt) * 0.8, -std::cos(tilt))));
}

TEST(PatternOf, EachBlockHasAllSixteenInAnOrderOfItsOwn) {
    std::set<std::vector<int>> orders;
    for (std::uint32_t y0 = 0; y0 < 64; y0 += 4) {
        for (std::uint32_t x0 = 0; x0 < 64; x0 += 4) {
            std::vector<int> order;
            for (std::uint32_t i = 0; i < 16; ++i)
                order.push_back(pattern_of(x0 + i % 4, y0 + i / 4));
            EXPECT_EQ(std::set<int>(order.begin(), order.end()).size(), 16U);
            orders.insert(order);
        }
    }
    EXPECT_EQ(orders.size(), 16U);  // all of the orders that a flip of bits can make
}

}  // namespace
}  // namespace foverig
