#include "rig/records/steady_times.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/rig/stats/series.h"

namespace foverig {
namespace {

std::vector<double> cold_then_steady(int n) {
    std::vector<double> times_ms;
    for (const double noise : stats::test::autoregressive(n, 0.3, 4))
        times_ms.push_back(8.0 + 0.1 * noise);
    times_ms[0] = 30.0;
    times_ms[1] = 20.0;
    return times_ms;
}

TEST(SteadyTimes, LeaveTheColdFramesOut) {
    const SteadyTimes steady = steady_times(cold_then_steady(90));
    EXPECT_EQ(steady.warm_up_frames, 2U);
    EXPECT_EQ(steady.n, 88U);
    EXPECT_LT(steady.effective_n, 88.0);
    EXPECT_NEAR(steady.percentiles[0].estimate->value, 8.0, 0.1);
}

TEST(SteadyTimes, SayNothingOfAPercentileThatTheyCannotKnow) {
    const nlohmann::json json = to_json(steady_times(cold_then_steady(90)));
    EXPECT_TRUE(json["p50"]["value"].is_number());
    EXPECT_EQ(json["p50"]["ci95"].size(), 2U);
    EXPECT_TRUE(json["p99"]["value"].is_null());
    EXPECT_TRUE(json["p99"]["ci95"].is_null());
    EXPECT_EQ(json["p99"]["needed_n"], 299U);
    EXPECT_TRUE(to_json(steady_times(cold_then_steady(900)))["p99"]["value"].is_number());
}

}  // namespace
}  // namespace foverig
