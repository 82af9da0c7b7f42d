#include "rig/sweep/page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rig/sweep/result.h"

namespace foverig::sweep {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// Three points: 10 ms and 0.3, 20 ms and 0.1, 30 ms and 0.2, which is the default.
Measured three_points() {
    Measured measured;
    measured.definition = {
        {"name", "three <points>"},
        {"scenario",
         {{"scene", "cornell"},
          {"cost", "measured"},
          {"frames", 4},
          {"display",
           {{"rate_hz", 75.0}, {"eyes", 1}, {"eye_width_px", 64}, {"eye_height_px", 48}}}}},
        {"devices", {{"dk2", {{"origin", "recorded"}, {"recorded_from", "hardware"}}}}},
        {"reference", json::object()},
        {"knobs", {"foveation.p_min"}},
        {"points",
         {{{"foveation.p_min", 0.1}}, {{"foveation.p_min", 0.2}}, {{"foveation.p_min", 0.3}}}},
        {"default_point", 2},
        {"repetitions", 2},
        {"warm_up_frames", 1},
        {"error", "flip"},
        {"within", {0.25, 0.01}},
        {"fixed_cost", false}};
    measured.build = {{"version", "1.2.3"}, {"git", nullptr}};
    measured.hosts = {{{"cpu", "Abacus"}, {"cores", 3}}};
    constexpr double kMs[] = {10.0, 20.0, 30.0};
    constexpr double kErrors[] = {0.3, 0.1, 0.2};
    for (std::size_t point = 0; point < 3; ++point) {
        Accuracy accuracy;
        accuracy.point = point;
        for (const std::string& name : error_names())
            accuracy.errors[name] = {9.0, kErrors[point], kErrors[point], kErrors[point]};
        accuracy.rays = {{"total", 1000.0}};
        accuracy.backend_bytes = 5'000'000;
        measured.accuracies[point] = accuracy;
        for (int repetition = 0; repetition < 2; ++repetition) {
            const double ms = kMs[point] + (repetition == 0 ? -0.5 : 0.5);
            measured.times[point].push_back(
                {point, repetition, {99, ms, ms, ms}, {{"a_short_one", 0.1}, {"trace", ms}}});
        }
    }
    return measured;
}

TEST(ParetoJson, HasTheFrontAndWhatAMillisecondBuys) {
    const auto pareto = pareto_json(three_points());
    ASSERT_EQ(pareto["front"].size(), 2U);
    EXPECT_EQ(pareto["front"][0]["point"], 0);
    EXPECT_EQ(pareto["front"][1]["point"], 1);
    EXPECT_NEAR(pareto["front"][0]["to_next"]["error_per_ms"].get<double>(), -0.02, 1e-12);
    EXPECT_TRUE(pareto["front"][1]["to_next"].is_null());
    EXPECT_EQ(pareto["cheapest_within"][0]["point"], 1);
    EXPECT_TRUE(pareto["cheapest_within"][1]["point"].is_null());
    EXPECT_EQ(pareto["points"][2]["default"], true);
    EXPECT_EQ(pareto["points"][2]["on_front"], false);
    EXPECT_DOUBLE_EQ(pareto["points"][1]["vsync"]["missed_ratio"].get<double>(), 0.5);
    EXPECT_DOUBLE_EQ(pareto["points"][2]["time_ms"]["value"].get<double>(), 30.0);
}

TEST(ParetoPage, SaysWhatTheJsonSays) {
    const std::string html = page(pareto_json(three_points()));
    EXPECT_THAT(html, HasSubstr("three &lt;points&gt;"));
    EXPECT_THAT(html, HasSubstr("VSync, 13.3 ms"));
    EXPECT_THAT(html, HasSubstr("point 2: p_min 0.3: 30 ms, error 0.2"));
    EXPECT_THAT(html, HasSubstr("p_min 0.3 <b>(default)</b>"));
    EXPECT_THAT(html, HasSubstr("no setting of this sweep"));
    EXPECT_THAT(html, HasSubstr("Abacus, 3 cores"));
    EXPECT_THAT(html, HasSubstr("Recorded: headset (a real one). Frame times are measured"));
    EXPECT_THAT(html, HasSubstr("n too small"));
    EXPECT_LT(html.find("<code>trace</code>"), html.find("<code>a_short_one</code>"))
        << "what takes longest comes first";
    EXPECT_THAT(html, testing::Not(HasSubstr("<script")));
    EXPECT_THAT(html, testing::Not(HasSubstr("://")));
}

TEST(ParetoPage, SaysThatTheMachineHadOtherWork) {
    EXPECT_TRUE(pareto_json(three_points())["elsewhere_processors"].is_null());
    Measured measured = three_points();
    for (auto& [point, runs] : measured.times)
        for (Times& run : runs) run.elsewhere_processors = point == 1 ? 0.5 : 0.01;
    const auto pareto = pareto_json(measured);
    EXPECT_DOUBLE_EQ(pareto["elsewhere_processors"]["p50"].get<double>(), 0.01);
    EXPECT_DOUBLE_EQ(pareto["elsewhere_processors"]["max"].get<double>(), 0.5);
    EXPECT_THAT(page(pareto), HasSubstr("others had up to 0.5 of the machine"));
    for (Times& run : measured.times[1]) run.elsewhere_processors = 0.02;
    EXPECT_THAT(page(pareto_json(measured)), testing::Not(HasSubstr("others had")));
}

TEST(ParetoPage, MarksTheFrontAndTheDefault) {
    const std::string html = page(pareto_json(three_points()));
    const auto count = [&](const std::string& what) {
        int n = 0;
        for (auto at = html.find(what); at != std::string::npos; at = html.find(what, at + 1)) ++n;
        return n;
    };
    EXPECT_EQ(count("r=\"5.00\" class=\"on-front\""), 2);
    EXPECT_EQ(count("r=\"3.50\" class=\"behind\""), 1);
    EXPECT_EQ(count("r=\"10.00\" class=\"default-ring\""), 1);
}

}  // namespace
}  // namespace foverig::sweep
