#include "rig/stats/bootstrap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "rig/stats/centre.h"
#include "tests/rig/stats/series.h"

namespace foverig::stats {
namespace {

using test::autoregressive;

// Two blocks of two out of three possible ones: nine equally likely series, enumerated here.
TEST(BlockBootstrap, DrawsEveryPairOfBlocksAlikeOften) {
    const std::vector<double> series{1.0, 2.0, 4.0, 8.0};
    std::map<double, int> expected;
    for (int first = 0; first < 3; ++first)
        for (int second = 0; second < 3; ++second) {
            const auto at = [&](int i) { return series[static_cast<std::size_t>(i)]; };
            ++expected[(at(first) + at(first + 1) + at(second) + at(second + 1)) / 4.0];
        }
    std::map<double, int> found;
    constexpr int kResamples = 18'000;
    for (const double mean :
         block_bootstrap(series, mean_of, {.block = 2, .resamples = kResamples, .seed = 3}))
        ++found[mean];
    ASSERT_EQ(found.size(), expected.size());
    for (const auto& [mean, ways] : expected)
        EXPECT_NEAR(found[mean], ways * kResamples / 9, 200) << mean;  // sigma <= 67
}

TEST(BlockBootstrap, RepeatsForASeed) {
    const auto series = autoregressive(60, 0.5, 2);
    const BootstrapSettings a{.resamples = 50, .seed = 1};
    const BootstrapSettings b{.resamples = 50, .seed = 2};
    EXPECT_EQ(block_bootstrap(series, mean_of, a), block_bootstrap(series, mean_of, a));
    EXPECT_NE(block_bootstrap(series, mean_of, a), block_bootstrap(series, mean_of, b));
}

// The mean of an autoregression has the variance (1 + phi) / (1 - phi) / n.
TEST(BlockBootstrap, KnowsHowFarTheMeanOfDependentNumbersIsOff) {
    constexpr int kN = 4000;
    for (const double phi : {0.0, 0.6}) {
        const auto interval =
            bootstrap_interval(autoregressive(kN, phi, 9), mean_of, {.block = 80}).value();
        const double sigma = std::sqrt((1.0 + phi) / (1.0 - phi) / kN);
        EXPECT_NEAR(interval.high - interval.low, 2.0 * 1.96 * sigma, 0.9 * sigma) << phi;
    }
}

TEST(BlockBootstrap, TakesLongerBlocksWhereDependenceReachesFurther) {
    EXPECT_EQ(block_length(std::vector<double>(1000, 1.0)), 10U);
    EXPECT_GT(block_length(autoregressive(1000, 0.95, 4)), 20U);
    EXPECT_EQ(block_length(std::vector<double>{}), 1U);
}

TEST(BootstrapInterval, IsAbsentOfTooFewBlocks) {
    EXPECT_FALSE(bootstrap_interval(autoregressive(19, 0.0, 1), mean_of, {.block = 4}));
    EXPECT_TRUE(bootstrap_interval(autoregressive(20, 0.0, 1), mean_of, {.block = 4}));
    EXPECT_FALSE(bootstrap_interval({}, mean_of));
}

}  // namespace
}  // namespace foverig::stats
