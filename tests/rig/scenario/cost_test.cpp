#include "rig/scenario/cost.h"

#include <gtest/gtest.h>

namespace foverig {
namespace {

TEST(Cost, IsMeasuredOrFixed) {
    ASSERT_TRUE(parse_cost("measured").has_value());
    EXPECT_FALSE(parse_cost("measured")->fixed_ms.has_value());
    EXPECT_EQ(parse_cost("fixed:12.5")->fixed_ms, 12.5);
    EXPECT_EQ(parse_cost("fixed:0")->fixed_ms, 0.0);
}

TEST(Cost, RefusesAnythingElse) {
    for (const char* text : {"", "fixed", "fixed:", "fixed:-1", "fixed:1e9", "fixed:nan",
                             "fixed:5ms", "Measured", "5"}) {
        EXPECT_FALSE(parse_cost(text).has_value()) << text;
    }
}

}  // namespace
}  // namespace foverig
