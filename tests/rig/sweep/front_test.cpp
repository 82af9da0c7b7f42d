#include "rig/sweep/front.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulators/motion/random.h"

namespace foverig::sweep {
namespace {

using Indices = std::vector<std::size_t>;

TEST(Front, IsWhatNothingBeatsInBoth) {
    const std::vector<Place> places{{5, 1}, {1, 5}, {3, 3}, {4, 4}, {3, 4}, {2, 5}, {9, 1}};
    EXPECT_EQ(front_of(places), (Indices{1, 2, 0}));
    EXPECT_EQ(front_of({}), Indices{});
    EXPECT_EQ(front_of({{2, 2}, {2, 2}, {2, 1}}), (Indices{2}));
}

TEST(Front, AgreesWithComparingAllWithAll) {
    const motion::Draws draws(4, 4);
    for (std::uint64_t trial = 0; trial < 200; ++trial) {
        std::vector<Place> places;
        for (std::uint64_t i = 0; i < 30; ++i)
            places.push_back({std::floor(10.0 * draws.uniform(100 * trial + 2 * i)),
                              std::floor(10.0 * draws.uniform(100 * trial + 2 * i + 1))});
        const Indices front = front_of(places);
        for (std::size_t i = 0; i < places.size(); ++i) {
            bool beaten = false;
            for (std::size_t j = 0; j < places.size(); ++j) {
                const bool no_worse =
                    places[j].ms <= places[i].ms && places[j].error <= places[i].error;
                const bool equal =
                    places[j].ms == places[i].ms && places[j].error == places[i].error;
                beaten = beaten || (no_worse && (!equal || j < i));
            }
            EXPECT_EQ(std::find(front.begin(), front.end(), i) != front.end(), !beaten);
        }
    }
}

TEST(CheapestWithin, IsTheFirstOfTheFrontThatIsGoodEnough) {
    const std::vector<Place> places{{5, 1}, {1, 5}, {3, 3}};
    const Indices front = front_of(places);
    EXPECT_EQ(cheapest_within(places, front, 10.0), 1U);
    EXPECT_EQ(cheapest_within(places, front, 3.0), 2U);
    EXPECT_EQ(cheapest_within(places, front, 2.9), 0U);
    EXPECT_FALSE(cheapest_within(places, front, 0.5).has_value());
}

}  // namespace
}  // namespace foverig::sweep
