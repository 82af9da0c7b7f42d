#include "rig/text/nearest.h"

#include <gtest/gtest.h>

namespace foverig {
namespace {

TEST(EditDistance, KnowsTheTextbookPair) {
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
    EXPECT_EQ(edit_distance("flaw", "lawn"), 2U);
}

TEST(EditDistance, IsTheLengthAgainstNothing) {
    EXPECT_EQ(edit_distance("", "abc"), 3U);
    EXPECT_EQ(edit_distance("abc", ""), 3U);
    EXPECT_EQ(edit_distance("", ""), 0U);
}

TEST(Nearest, FindsTheMisspeltWord) {
    EXPECT_EQ(nearest("foveaton.r0_deg", {"display.eyes", "foveation.r0_deg", "seed"}),
              "foveation.r0_deg");
}

TEST(Nearest, IsEmptyWithoutCandidates) {
    EXPECT_EQ(nearest("x", {}), "");
}

}  // namespace
}  // namespace foverig
