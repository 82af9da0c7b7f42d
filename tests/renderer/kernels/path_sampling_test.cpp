#include "renderer/kernels/path_sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "tests/renderer/chi_square.h"

namespace foverig {
namespace {

TEST(ShuffledIndex, IsAPermutationThatKeepsAlignedRunsTogether) {
    for (const std::uint32_t seed : {0U, 1U, 0xCAFEF00DU}) {
        std::set<std::uint32_t> all;
        for (std::uint32_t i = 0; i < 65536; ++i) all.insert(shuffled_index(i, seed));
        EXPECT_EQ(all.size(), 65536U);
        for (const std::uint32_t length : {2U, 16U, 256U}) {
            for (std::uint32_t first = 0; first < 65536; first += 7 * length) {
                std::set<std::uint32_t> runs;
                for (std::uint32_t i = first; i < first + length; ++i)
                    runs.insert(shuffled_index(i, seed) / length);
                ASSERT_EQ(runs.size(), 1U) << length;
            }
        }
    }
}

TEST(ShuffledIndex, DiffersFromSeedToSeed) {
    int same = 0;
    for (std::uint32_t i = 0; i < 1000; ++i)
        same += shuffled_index(i, 1U) == shuffled_index(i, 2U) ? 1 : 0;
    EXPECT_LT(same, 10);
}

TEST(PathSampler, SamplesOfAPixelAreANetInEveryPairOfDimensions) {
    for (const std::uint32_t dimension : {0U, 2U, 5U}) {
        for (const std::uint32_t n : {16U, 64U, 256U}) {
            const auto side =
                static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(n))));
            std::set<std::uint32_t> cells;
            for (std::uint32_t i = 0; i < n; ++i) {
                const vec2 p = PathSampler{9U, i}.point(0x00120034U, 1, dimension);
                cells.insert(static_cast<std::uint32_t>(p.x * static_cast<float>(side)) * side +
                             static_cast<std::uint32_t>(p.y * static_cast<float>(side)));
            }
            EXPECT_EQ(cells.size(), n);
        }
    }
}

TEST(PathSampler, PairsOfDimensionsAreIndependent) {
    // 4x4 cells of one pair against 4x4 cells of another, over samples and pixels: without the
    // shuffle only 16 of the 256 combinations occur within a pixel.
    std::vector<double> counts(256);
    std::set<std::uint32_t> of_one_pixel;
    for (std::uint32_t pixel = 0; pixel < 400; ++pixel) {
        for (std::uint32_t i = 0; i < 256; ++i) {
            const PathSampler s{3U, i};
            const vec2 a = s.point(pixel, 0, kLensPair);
            const vec2 b = s.point(pixel, 1, kDirectionPair);
            const auto cell = [](vec2 p) {
                return static_cast<std::uint32_t>(p.x * 4.0F) * 4 +
                       static_cast<std::uint32_t>(p.y * 4.0F);
            };
            ++counts[cell(a) * 16 + cell(b)];
            if (pixel == 0) of_one_pixel.insert(cell(a) * 16 + cell(b));
        }
    }
    EXPECT_LT(chi_square(counts, std::vector<double>(256, 400.0)), chi_square_bound(255));
    EXPECT_GT(of_one_pixel.size(), 120U);
}

}  // namespace
}  // namespace foverig
