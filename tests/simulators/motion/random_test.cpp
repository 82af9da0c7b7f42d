#include "simulators/motion/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace foverig::motion {
namespace {

// The published first outputs of splitmix64 with seed 0: its state steps by the golden gamma, which
// mix64 adds itself.
TEST(Mix64, GivesSplitmixFirstNumbers) {
    EXPECT_EQ(mix64(0), 0xE220A8397B1DCDAFu);
    EXPECT_EQ(mix64(0x9E3779B97F4A7C15u), 0x6E789E6AA1B965F4u);
    EXPECT_EQ(mix64(2 * 0x9E3779B97F4A7C15u), 0x06C45D188009454Fu);
}

TEST(Draws, UniformIsFlatByChiSquare) {
    const Draws draws(7, 3);
    std::array<int, 64> bins{};
    constexpr int kDraws = 64000;
    for (int i = 0; i < kDraws; ++i) ++bins[static_cast<std::size_t>(64.0 * draws.uniform(i))];
    double chi2 = 0.0;
    for (const int n : bins) chi2 += (n - 1000.0) * (n - 1000.0) / 1000.0;
    EXPECT_LT(chi2, 103.4);  // 63 degrees of freedom, p = 0.001
    EXPECT_GT(chi2, 32.0);   // and p = 0.999: not flatter than chance
}

TEST(Draws, NormalHasNormalMoments) {
    const Draws draws(1, 2);
    double sum = 0, square = 0, fourth = 0;
    constexpr int kDraws = 200000;
    for (int i = 0; i < kDraws; ++i) {
        const double x = draws.normal(i);
        sum += x;
        square += x * x;
        fourth += x * x * x * x;
    }
    EXPECT_NEAR(sum / kDraws, 0.0, 0.01);
    EXPECT_NEAR(square / kDraws, 1.0, 0.015);
    EXPECT_NEAR(fourth / kDraws, 3.0, 0.12);
}

TEST(Draws, StreamsAndNeighboursAreUncorrelated) {
    const Draws a(1, 2), b(1, 3), c(2, 2);
    double ab = 0, ac = 0, lag = 0;
    constexpr int kDraws = 100000;
    for (int i = 0; i < kDraws; ++i) {
        ab += a.normal(i) * b.normal(i);
        ac += a.normal(i) * c.normal(i);
        lag += a.normal(i) * a.normal(i + 1);
    }
    const double four_sigma = 4.0 / std::sqrt(static_cast<double>(kDraws));
    EXPECT_NEAR(ab / kDraws, 0.0, four_sigma);
    EXPECT_NEAR(ac / kDraws, 0.0, four_sigma);
    EXPECT_NEAR(lag / kDraws, 0.0, four_sigma);
}

TEST(Draws, LogNormalHasItsMedianAndExponentialItsMean) {
    const Draws draws(5, 5);
    int below = 0;
    double sum = 0;
    constexpr int kDraws = 100000;
    for (int i = 0; i < kDraws; ++i) {
        below += draws.log_normal(i, 25.0, 0.5) < 25.0 ? 1 : 0;
        sum += draws.exponential(i, 0.7);
    }
    EXPECT_NEAR(below / static_cast<double>(kDraws), 0.5, 0.007);
    EXPECT_NEAR(sum / kDraws, 0.7, 0.01);
}

}  // namespace
}  // namespace foverig::motion
