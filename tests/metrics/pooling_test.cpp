#include "metrics/pooling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/metrics/pictures.h"

namespace foverig::metrics {
namespace {

/// The definition, by sorting everything.
double sorted_quantile(std::vector<float> errors, double q) {
    std::sort(errors.begin(), errors.end());
    const double total = std::accumulate(errors.begin(), errors.end(), 0.0);
    double running = 0.0;
    for (const float e : errors)
        if ((running += double{e}) > q * total) return double{e};
    return 0.0;
}

TEST(Pool, GivesTheQuantilesOfTheSortedErrors) {
    Plane errors(101, 53);
    const Image noise = test::noise(101, 53, 5);
    for (std::size_t i = 0; i < errors.values.size(); ++i)
        errors.values[i] = noise.pixels[i].x * noise.pixels[i].y * 0.37F;
    const Pooled pooled = pool(errors);
    EXPECT_EQ(pooled.weighted_q1, sorted_quantile(errors.values, 0.25));
    EXPECT_EQ(pooled.weighted_median, sorted_quantile(errors.values, 0.5));
    EXPECT_EQ(pooled.weighted_q3, sorted_quantile(errors.values, 0.75));
    EXPECT_EQ(pooled.max, double{*std::max_element(errors.values.begin(), errors.values.end())});
}

TEST(Pool, WeighsLargeErrorsMore) {
    Plane errors(4, 1);
    errors.values = {0.1F, 0.1F, 0.1F, 0.9F};
    EXPECT_FLOAT_EQ(static_cast<float>(pool(errors).weighted_median), 0.9F);
    EXPECT_FLOAT_EQ(static_cast<float>(pool(errors).mean), 0.3F);
}

TEST(Pool, IsZeroOfNoErrorAndOfNoPixel) {
    EXPECT_EQ(pool(Plane(5, 5)).weighted_median, 0.0);
    EXPECT_EQ(pool(Plane(0, 0)).mean, 0.0);
}

}  // namespace
}  // namespace foverig::metrics
