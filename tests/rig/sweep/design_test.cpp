#include "rig/sweep/design.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace foverig::sweep {
namespace {

Knob list(const char* key, std::vector<KeyValue> values) {
    Knob knob;
    knob.key = find_key(key);
    knob.values = std::move(values);
    return knob;
}

Knob range(const char* key, double from, double to, bool logarithmic = false) {
    Knob knob;
    knob.key = find_key(key);
    knob.from = from;
    knob.to = to;
    knob.logarithmic = logarithmic;
    return knob;
}

TEST(Grid, HasEveryCombinationOnce) {
    const auto points = grid({list("foveation.p_min", {0.1, 0.2, 0.3}),
                              list("lighting.area_samples", {std::int64_t{1}, std::int64_t{8}})});
    ASSERT_EQ(points.size(), 6U);
    EXPECT_EQ(text_of(points[0]), "foveation.p_min = 0.1, lighting.area_samples = 1");
    EXPECT_EQ(text_of(points[1]), "foveation.p_min = 0.1, lighting.area_samples = 8");
    EXPECT_EQ(text_of(points[5]), "foveation.p_min = 0.3, lighting.area_samples = 8");
}

// What makes it a Latin hypercube (McKay et al. 1979): one point in each of n parts of each range.
TEST(LatinHypercube, MeetsEveryPartOfEveryRangeOnce) {
    constexpr std::size_t kN = 30;
    const auto points = latin_hypercube(
        {range("foveation.p_min", 0.1, 0.4), range("reprojection.epsilon_lum", 0.01, 1.0, true),
         list("pipeline", {std::string("full"), std::string("reprojected")})},
        kN, 7);
    ASSERT_EQ(points.size(), kN);
    std::set<int> linear_parts, log_parts;
    int full = 0;
    for (const Settings& settings : points) {
        const double p_min = std::get<double>(settings[0].second);
        const double lum = std::get<double>(settings[1].second);
        linear_parts.insert(static_cast<int>(std::floor((p_min - 0.1) / 0.3 * kN)));
        log_parts.insert(static_cast<int>(std::floor(std::log(lum / 0.01) / std::log(100.0) * kN)));
        full += std::get<std::string>(settings[2].second) == "full" ? 1 : 0;
    }
    EXPECT_EQ(linear_parts.size(), kN);
    EXPECT_EQ(log_parts.size(), kN);
    EXPECT_EQ(*linear_parts.begin(), 0);
    EXPECT_EQ(full, 15);
}

TEST(LatinHypercube, IsTheSameForASeedAndAnotherForAnother) {
    const std::vector<Knob> knobs{range("foveation.p_min", 0.0, 1.0), range("threads", 1.0, 64.0)};
    EXPECT_EQ(latin_hypercube(knobs, 8, 1), latin_hypercube(knobs, 8, 1));
    EXPECT_NE(latin_hypercube(knobs, 8, 1), latin_hypercube(knobs, 8, 2));
    EXPECT_TRUE(std::holds_alternative<std::int64_t>(latin_hypercube(knobs, 8, 1)[0][1].second));
}

TEST(Shuffled, IsAPermutationAndEachPlaceAsLikely) {
    std::vector<int> first_place(5, 0);
    for (std::uint64_t stream = 0; stream < 5000; ++stream) {
        const auto order = shuffled(5, 3, stream);
        EXPECT_EQ(std::set<std::size_t>(order.begin(), order.end()).size(), 5U);
        ++first_place[order[0]];
    }
    for (const int count : first_place) EXPECT_NEAR(count, 1000, 140);  // 5 sigma
}

}  // namespace
}  // namespace foverig::sweep
