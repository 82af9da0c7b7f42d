#include "rig/stats/effective_count.h"

#include <gtest/gtest.h>

#include "tests/rig/stats/series.h"

namespace foverig::stats {
namespace {

using test::autoregressive;

// Of a first-order autoregression it is n (1 - phi) / (1 + phi).
TEST(EffectiveCount, OfAnAutoregressionIsTheTextbookOne) {
    for (const double phi : {0.0, 0.3, 0.6, 0.9}) {
        const double share = effective_count(autoregressive(40'000, phi, 5)) / 40'000;
        const double truth = (1.0 - phi) / (1.0 + phi);
        EXPECT_NEAR(share, truth, 0.12 * truth) << phi;
    }
}

TEST(EffectiveCount, IsNeverMoreThanThereAre) {
    EXPECT_EQ(effective_count(std::vector<double>{}), 0.0);
    EXPECT_EQ(effective_count(std::vector<double>{4.0}), 1.0);
    EXPECT_EQ(effective_count(std::vector<double>(50, 2.0)), 50.0);
    EXPECT_EQ(effective_count(std::vector<double>{1, 2, 1, 2, 1, 2, 1, 2}), 8.0);
}

TEST(EffectiveCount, OfARampIsNextToNothing) {
    std::vector<double> ramp;
    for (int i = 0; i < 200; ++i) ramp.push_back(i);
    EXPECT_LT(effective_count(ramp), 4.0);
}

}  // namespace
}  // namespace foverig::stats
