#include "rig/compare/told.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/rig/compare/synthetic_runs.h"

namespace foverig::compare {
namespace {

using testing::HasSubstr;
using testing::Not;

test::Sides sides_with(double others, double stolen) {
    test::Sides sides = test::in_turns({}, 5, 1.0);
    sides.fresh[2].summary["processor_use"] = {{"others", others}, {"stolen", stolen}};
    return sides;
}

std::string told_of(const test::Sides& sides, const TimeSettings& settings = {}) {
    return told(compare_times(sides.base, sides.fresh, settings), settings, {});
}

TEST(Told, SaysThatTheMachineHadOtherWork) {
    const auto busy = sides_with(0.5, 1.26);
    EXPECT_THAT(told_of(busy), HasSubstr("others had up to 1.8 of its processors"));
    EXPECT_THAT(told_of(busy), HasSubstr("--of cpu_ms leaves that out"));
    const auto json = to_json(compare_times(busy.base, busy.fresh, {}), {}, {});
    EXPECT_NEAR(json.at("elsewhere_processors").get<double>(), 1.76, 1e-12);
}

TEST(Told, DoesNotWhereItWasTooLittleToMatterOrIsNotKnown) {
    EXPECT_THAT(told_of(sides_with(0.05, 0.04)), Not(HasSubstr("others had")));
    const auto unknown = test::in_turns({}, 5, 1.0);
    EXPECT_THAT(told_of(unknown), Not(HasSubstr("others had")));
    const auto json = to_json(compare_times(unknown.base, unknown.fresh, {}), {}, {});
    EXPECT_TRUE(json.at("elsewhere_processors").is_null());
}

TEST(Told, IsSilentWhereProcessorTimeIsCompared) {
    auto busy = sides_with(0.5, 1.26);
    for (auto* side : {&busy.base, &busy.fresh})
        for (report::RunData& run : *side) {
            run.frames.order.push_back("cpu_ms");
            run.frames.columns["cpu_ms"] = run.frames.columns["frame_time_ms"];
        }
    EXPECT_THAT(told_of(busy, {.of = "cpu_ms"}), Not(HasSubstr("others had")));
}

}  // namespace
}  // namespace foverig::compare
