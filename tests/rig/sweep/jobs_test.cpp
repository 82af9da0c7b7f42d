#include "rig/sweep/jobs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "rig/failure.h"

namespace foverig::sweep {
namespace {

Sweep of_points(std::size_t points, int repetitions, Order order = Order::abba) {
    Sweep sweep;
    sweep.points.resize(points);
    sweep.repetitions = repetitions;
    sweep.order = order;
    return sweep;
}

std::vector<std::size_t> points_of(const std::vector<Job>& jobs, int repetition) {
    std::vector<std::size_t> points;
    for (const Job& job : jobs)
        if (job.repetition == repetition) points.push_back(job.point);
    return points;
}

TEST(Jobs, GoForwardAndBackwardInTurns) {
    const auto jobs = jobs_of(of_points(3, 3), {});
    ASSERT_EQ(jobs.size(), 12U);
    EXPECT_EQ(points_of(jobs, -1), (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_EQ(points_of(jobs, 0), (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_EQ(points_of(jobs, 1), (std::vector<std::size_t>{2, 1, 0}));
    EXPECT_EQ(points_of(jobs, 2), (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_TRUE(std::is_sorted(jobs.begin(), jobs.end(), [](const Job& a, const Job& b) {
        return a.repetition < b.repetition;
    }));
}

// The mean place of each point in two rounds is the same: a steady drift adds alike to all.
TEST(Jobs, InAbbaOrderCancelASteadyDrift) {
    const auto jobs = jobs_of(of_points(7, 2), {});
    std::vector<std::size_t> places(7, 0);
    for (std::size_t i = 7; i < jobs.size(); ++i) places[jobs[i].point] += i;
    EXPECT_EQ(std::set<std::size_t>(places.begin(), places.end()).size(), 1U);
}

TEST(Jobs, AreShuffledAnewForEachRepetition) {
    const auto jobs = jobs_of(of_points(20, 2, Order::random), {});
    auto first = points_of(jobs, 0);
    auto second = points_of(jobs, 1);
    EXPECT_NE(first, second);
    std::sort(first.begin(), first.end());
    std::sort(second.begin(), second.end());
    EXPECT_EQ(first, second);
}

TEST(Jobs, OfAllShardsAreThoseOfTheWhole) {
    for (const Order order : {Order::abba, Order::random}) {
        const Sweep sweep = of_points(10, 2, order);
        std::vector<Job> all;
        for (std::size_t i = 0; i < 3; ++i)
            for (const Job& job : jobs_of(sweep, {i, 3})) all.push_back(job);
        const auto whole = jobs_of(sweep, {});
        EXPECT_EQ(all.size(), whole.size());
        for (const Job& job : whole) EXPECT_EQ(std::count(all.begin(), all.end(), job), 1);
    }
}

TEST(Jobs, AtFixedCostAreForAccuracyAlone) {
    Sweep sweep = of_points(4, 3);
    sweep.base.cost = "fixed:9";
    EXPECT_EQ(jobs_of(sweep, {}).size(), 4U);
}

TEST(Shard, IsAPartOfSomany) {
    EXPECT_EQ(parse_shard("3/16").index, 3U);
    EXPECT_EQ(parse_shard("3/16").count, 16U);
    for (const char* bad : {"", "3", "3/", "/3", "3/3", "-1/3", "0/0", "1/2x", "a/b", "0/99999"})
        EXPECT_THROW(parse_shard(bad), UsageError) << bad;
}

}  // namespace
}  // namespace foverig::sweep
