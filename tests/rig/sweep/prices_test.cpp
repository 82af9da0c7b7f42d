#include "rig/sweep/prices.h"

#include <gtest/gtest.h>

#include "renderer/scene/library.h"
#include "rig/sweep/price_table.h"
#include "rig/sweep/records.h"
#include "rig/sweep/result.h"

namespace foverig::sweep {
namespace {

using nlohmann::json;

/// The base costs 10 ms at an error of 0.1; without its lamp 7 ms at 0.4, without reprojection
/// 25 ms at 0.02. Frames vary by the same in all three.
Measured priced() {
    Measured measured;
    measured.definition = {{"points",
                            {{{"foveation.p_min", 0.05}},
                             {{"foveation.p_min", 0.05}, {"effects.area_light", "off"}},
                             {{"foveation.p_min", 0.05}, {"pipeline", "full"}}}},
                           {"default_point", 0},
                           {"price_points", {{"area_light", 1}, {"reprojection", 2}}},
                           {"repetitions", 3},
                           {"warm_up_frames", 1},
                           {"error", "flip"},
                           {"fixed_cost", false}};
    constexpr double kMs[] = {10.0, 7.0, 25.0};
    constexpr double kErrors[] = {0.1, 0.4, 0.02};
    for (std::size_t point = 0; point < 3; ++point) {
        Accuracy accuracy;
        accuracy.point = point;
        accuracy.errors["flip"] = {9.0};
        for (int i = 0; i < 40; ++i)
            accuracy.errors["flip"].push_back(kErrors[point] * (1.0 + 0.002 * (i * 7 % 5 - 2)) +
                                              0.05 * (i * 3 % 8));
        measured.accuracies[point] = accuracy;
        for (int run = 0; run < 3; ++run) {
            const double ms = kMs[point] * (1.0 + 0.001 * run);  // the machine drifts
            measured.times[point].push_back({point, run, {500.0, ms, ms, ms}, {}});
        }
    }
    return measured;
}

TEST(Prices, AreWhatTheScenarioLosesWithoutAnEffect) {
    const auto prices = prices_json(priced());
    ASSERT_EQ(prices.size(), 2U);
    EXPECT_EQ(prices[0]["effect"], "area_light") << "the dearest first";
    EXPECT_NEAR(prices[0]["ms"]["value"].get<double>(), 3.0, 0.01);
    EXPECT_NEAR(prices[0]["error"]["value"].get<double>(), 0.3, 1e-12);
    EXPECT_NEAR(prices[0]["error_per_ms"].get<double>(), 0.1, 1e-3);
    EXPECT_EQ(prices[1]["left_out"], "pipeline = full");
    EXPECT_NEAR(prices[1]["ms"]["value"].get<double>(), -15.0, 0.05) << "it saves them";
    EXPECT_NEAR(prices[1]["error"]["value"].get<double>(), -0.08, 1e-12);
}

TEST(Prices, ComparesFramesWithThemselvesSoThatTheirSpreadIsNoUncertainty) {
    const auto prices = prices_json(priced());
    ASSERT_TRUE(prices[0]["error"]["ci95"].is_array());
    EXPECT_NEAR(prices[0]["error"]["ci95"][0].get<double>(), 0.3, 0.002);
    EXPECT_NEAR(prices[0]["error"]["ci95"][1].get<double>(), 0.3, 0.002);
}

TEST(Prices, HaveNoMillisecondsAtFixedCost) {
    Measured measured = priced();
    measured.definition["fixed_cost"] = true;
    measured.times.clear();
    const auto prices = prices_json(measured);
    EXPECT_TRUE(prices[0]["ms"].is_null());
    EXPECT_TRUE(prices[0]["error_per_ms"].is_null());
    EXPECT_NE(price_table({{"prices", prices}}).find("effects.area_light = off"),
              std::string::npos);
}

TEST(Prices, StandBehindTheDesignAndOffItsFront) {
    EXPECT_EQ(design_points(priced().definition), 1U);
    EXPECT_EQ(design_points({{"points", {1, 2, 3}}}), 3U);
}

TEST(PricePoints, AreTheEffectsThatAreOnAndCanBeLeftOut) {
    Sweep sweep;
    sweep.points.push_back({{{"foveation.p_min", 0.05}}, sweep.base});
    sweep.default_point = 0;
    const EffectPlan plan(make_builtin_scene("cornell", 0.2), sweep.base.render);
    add_price_points(sweep, plan);
    ASSERT_EQ(sweep.price_points.size() + 1, sweep.points.size());
    for (const PlannedEffect& planned : plan.effects()) {
        const bool own = planned.name == "reprojection" || follows_from(planned.name).empty();
        EXPECT_EQ(sweep.price_points.contains(planned.name), planned.on && own) << planned.name;
    }
    const std::size_t without = sweep.price_points.at("reprojection");
    EXPECT_EQ(sweep.points[without].scenario.render.pipeline, "full");
    const std::size_t raw = sweep.price_points.at("post_process");
    EXPECT_EQ(sweep.points[raw].scenario.render.effects.at("post_process"), "off");
}

}  // namespace
}  // namespace foverig::sweep
