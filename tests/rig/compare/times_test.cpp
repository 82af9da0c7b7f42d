#include "rig/compare/times.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rig/failure.h"
#include "tests/rig/compare/synthetic_runs.h"

namespace foverig::compare {
namespace {

using stats::Verdict;
using test::in_turns;
using test::Machine;
using test::Sides;

struct Tally {
    int worse = 0, better = 0, same = 0, cannot_tell = 0;
};

/// Verdicts of 20 comparisons of 10 runs a side, each on a machine of its own luck.
Tally verdicts(const Machine& machine, double slower, bool paired) {
    Tally tally;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Machine lucky = machine;
        lucky.seed = seed;
        const Sides sides = in_turns(lucky, 10, slower);
        switch (compare_times(sides.base, sides.fresh, {.paired = paired}).judgement.verdict) {
            case Verdict::worse:
                ++tally.worse;
                break;
            case Verdict::better:
                ++tally.better;
                break;
            case Verdict::same:
                ++tally.same;
                break;
            case Verdict::cannot_tell:
                ++tally.cannot_tell;
                break;
        }
    }
    return tally;
}

constexpr Machine kCalm{};
constexpr Machine kDrifting{.drift = 0.08};
constexpr Machine kNoisy{.run_sigma = 0.05, .drift = 0.2, .frame_sigma = 0.1, .late_share = 0.1};

TEST(Compare, FindsNoneWorseWhereNothingChanged) {
    for (const Machine& machine : {kCalm, kDrifting, kNoisy})
        for (const bool paired : {false, true}) {
            const Tally tally = verdicts(machine, 1.0, paired);
            EXPECT_LE(tally.worse, 1);
            EXPECT_LE(tally.better, 1);
        }
    EXPECT_EQ(verdicts(kCalm, 1.0, false).same, 20);
    EXPECT_EQ(verdicts(kDrifting, 1.0, true).same, 20);
}

TEST(Compare, FindsFivePercentOfTenRunsEach) {
    EXPECT_GE(verdicts(kCalm, 1.05, false).worse, 19);
    EXPECT_GE(verdicts(kDrifting, 1.05, true).worse, 19);
    EXPECT_GE(verdicts(kCalm, 1.0 / 1.05, false).better, 19);
}

TEST(Compare, NeverCallsFivePercentBetterOrTheSame) {
    for (const bool paired : {false, true}) {
        const Tally tally = verdicts(kNoisy, 1.05, paired);
        EXPECT_EQ(tally.better, 0);
        EXPECT_EQ(tally.same, 0);
        EXPECT_GE(tally.cannot_tell, 10) << "ten runs cannot tell here, and it says so";
    }
}

TEST(Compare, LeavesTheColdFramesOfAllRunsOut) {
    const Sides sides = in_turns(kCalm, 5, 1.0);
    const TimeComparison c = compare_times(sides.base, sides.fresh, {});
    EXPECT_GE(c.warm_up_frames, 1U);
    EXPECT_LE(c.warm_up_frames, 6U);
    EXPECT_EQ(c.base.size(), 5U);
    EXPECT_NEAR(c.relative.value, c.shift.value / 12.0, 0.002);
}

TEST(Compare, ComparesAnyColumn) {
    const Sides sides = in_turns(kCalm, 5, 1.05);
    const auto whole = compare_times(sides.base, sides.fresh, {});
    const auto pass = compare_times(sides.base, sides.fresh, {.of = "pass.trace_ms"});
    EXPECT_NEAR(pass.shift.value, 0.7 * whole.shift.value, 1e-9);
    EXPECT_NEAR(pass.relative.value, whole.relative.value, 1e-9);
}

TEST(Compare, SaysWhatItCannotDo) {
    const Sides sides = in_turns(kCalm, 2, 1.0);
    const auto single = compare_times({sides.base[0]}, {sides.fresh[0]}, {});
    EXPECT_EQ(single.judgement.verdict, Verdict::cannot_tell);
    EXPECT_EQ(single.judgement.runs_needed, 4U);
    const auto complaint = [&](const TimeSettings& settings) -> std::string {
        try {
            compare_times(sides.base, {sides.fresh[0]}, settings);
        } catch (const UsageError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_THAT(complaint({.of = "frame_tim_ms"}), testing::HasSubstr("nearest is frame_time_ms"));
    EXPECT_THAT(complaint({.paired = true}), testing::HasSubstr("2 runs against 1"));
}

}  // namespace
}  // namespace foverig::compare
