#include "rig/records/fail_if.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "rig/failure.h"

namespace foverig {
namespace {

nlohmann::json summary() {
    return {{"vsync", {{"missed_ratio", 0.02}, {"missed", 3}}},
            {"pass_time_ms", {{"trace.primary", {{"p99", 4.0}}}}},
            {"latency_ms", {{"gaze_to_photon", nullptr}}}};
}

bool fails(const std::string& text) {
    return failure(parse_fail_if(text), summary()).has_value();
}

TEST(FailIf, ReadsKeyComparisonAndNumber) {
    const FailIf check = parse_fail_if("  vsync.missed_ratio>=1e-2 ");
    EXPECT_EQ(check.key, "vsync.missed_ratio");
    EXPECT_EQ(check.comparison, ">=");
    EXPECT_EQ(check.bound, 0.01);
}

TEST(FailIf, KnowsEveryComparison) {
    EXPECT_TRUE(fails("vsync.missed > 2"));
    EXPECT_FALSE(fails("vsync.missed > 3"));
    EXPECT_TRUE(fails("vsync.missed >= 3"));
    EXPECT_TRUE(fails("vsync.missed < 4"));
    EXPECT_TRUE(fails("vsync.missed <= 3"));
    EXPECT_TRUE(fails("vsync.missed == 3"));
    EXPECT_FALSE(fails("vsync.missed != 3"));
    EXPECT_TRUE(fails("vsync.missed_ratio > -1"));
}

TEST(FailIf, FindsNamesThatHoldADot) {
    EXPECT_TRUE(fails("pass_time_ms.trace.primary.p99 > 3"));
}

TEST(FailIf, FailsOnWhatWasNotMeasured) {
    EXPECT_THAT(failure(parse_fail_if("latency_ms.gaze_to_photon > 50"), summary()).value_or(""),
                testing::HasSubstr("absent"));
}

TEST(FailIf, FailsOnANumberOfWhatWasNotMeasured) {
    EXPECT_THAT(
        failure(parse_fail_if("latency_ms.gaze_to_photon.p99 > 50"), summary()).value_or(""),
        testing::HasSubstr("absent"));
}

TEST(FailIf, NamesTheNearestKey) {
    try {
        failure(parse_fail_if("vsync.mised_ratio > 0"), summary());
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("nearest is vsync.missed_ratio"));
    }
    EXPECT_THROW(failure(parse_fail_if("vsync > 0"), summary()), UsageError);
}

TEST(FailIf, RefusesWhatItCannotRead) {
    for (const char* text :
         {"", "vsync.missed", "vsync.missed > ", "> 3", "vsync.missed > many", "vsync.missed = 3",
          "vsync.missed > 3 ms", "a b > 3", "vsync.missed > nan", "vsync.missed < inf"}) {
        EXPECT_THROW(parse_fail_if(text), UsageError) << text;
    }
}

}  // namespace
}  // namespace foverig
