// The search against the whole grid of functions whose best place is known.
#include "rig/sweep/search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace foverig::sweep {
namespace {

/// Samples and radius cost milliseconds and lower the error, one more than the other.
Place priced(const GridPlace& place) {
    const auto samples = static_cast<double>(place[0] + 1);
    const auto radius = static_cast<double>(place[1] + 1);
    return {2.0 * samples + radius, 1.0 / samples + 0.3 / radius};
}

Place best_of_grid(const std::vector<std::size_t>& sizes, double budget_ms) {
    Place best{INFINITY, INFINITY};
    for (std::size_t a = 0; a < sizes[0]; ++a)
        for (std::size_t b = 0; b < sizes[1]; ++b)
            if (const Place place = priced({a, b});
                place.ms <= budget_ms && place.error < best.error)
                best = place;
    return best;
}

TEST(Search, FindsTheBestOfAGridWithoutAllOfIt) {
    const std::vector<std::size_t> sizes{12, 12};
    for (const double budget_ms : {5.0, 9.0, 14.0, 23.0, 100.0})
        for (const GridPlace& start : {GridPlace{0, 0}, GridPlace{11, 11}, GridPlace{3, 8}}) {
            const auto [steps, at] = search(sizes, start, budget_ms, priced);
            const Place best = steps[at].found;
            EXPECT_LE(best.ms, budget_ms);
            EXPECT_LE(best.error, 1.02 * best_of_grid(sizes, budget_ms).error)
                << budget_ms << " ms from " << start[0] << ", " << start[1];
            EXPECT_LT(steps.size(), 80U);
        }
}

TEST(Search, AsksForNoPlaceTwiceAndStaysOnTheGrid) {
    const std::vector<std::size_t> sizes{4, 7};
    const auto steps = search(sizes, {2, 2}, 9.0, priced).steps;
    std::set<GridPlace> asked;
    for (const SearchStep& step : steps) {
        EXPECT_TRUE(asked.insert(step.place).second);
        EXPECT_LT(step.place[0], 4U);
        EXPECT_LT(step.place[1], 7U);
    }
    EXPECT_TRUE(steps.front().better);
}

TEST(Search, GivesTheCheapestWhereNothingFits) {
    const auto [steps, best] = search({5, 5}, {4, 4}, 1.0, priced);
    EXPECT_EQ(steps[best].place, (GridPlace{0, 0}));
}

TEST(Search, OfOneSettingIsThatSetting) {
    const auto only = [](const GridPlace&) { return Place{2.0, 0.5}; };
    const auto [steps, best] = search({1}, {0}, 1.0, only);
    EXPECT_EQ(steps.size(), 1U);
    EXPECT_EQ(steps[best].place, GridPlace{0});
}

}  // namespace
}  // namespace foverig::sweep
