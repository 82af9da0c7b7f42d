#include "rig/text/digest.h"

#include <gtest/gtest.h>

namespace foverig {
namespace {

// Published vectors of FNV-1a, 128 bits (draft-eastlake-fnv, appendix).
TEST(Digest, MatchesThePublishedVectors) {
    EXPECT_EQ(Digest().hex(), "6c62272e07bb014262b821756295c58d");
    EXPECT_EQ(Digest().add("a").hex(), "d228cb696f1a8caf78912b704e4a8964");
    EXPECT_EQ(Digest().add("foobar").hex(), "343e1662793c64bf6f0d3597ba446f18");
}

TEST(Digest, GoesByTheBytesAlone) {
    EXPECT_EQ(Digest().add("foo").add("bar").hex(), Digest().add("foobar").hex());
    EXPECT_NE(Digest().add("foobaz").hex(), Digest().add("foobar").hex());
}

}  // namespace
}  // namespace foverig
