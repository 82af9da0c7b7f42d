#include "devices/ring.h"

#include <gtest/gtest.h>

#include <deque>
#include <string>

namespace foverig {
namespace {

TEST(Ring, DoesAsADequeDoesThroughAnyPushesAndPops) {
    Ring<std::string> ring;
    std::deque<std::string> peer;
    unsigned hash = 1;
    std::size_t most = 0;
    for (int i = 0; i < 5000; ++i) {
        hash = hash * 1664525U + 1013904223U;
        // Slow waves, so that it grows, empties and goes round at every size.
        if (peer.empty() || hash >> 16U < (i / 500 % 2 == 0 ? 40'000U : 25'000U)) {
            EXPECT_EQ(ring.push_back(std::to_string(i)), std::to_string(i));
            peer.push_back(std::to_string(i));
        } else {
            ASSERT_EQ(ring.pop_front(), peer.front());
            peer.pop_front();
        }
        ASSERT_EQ(ring.size(), peer.size());
        for (std::size_t k = 0; k < peer.size(); k += 7) ASSERT_EQ(ring[k], peer[k]);
        most = std::max(most, peer.size());
    }
    EXPECT_GT(most, 50U);
    EXPECT_EQ(ring.take(), std::vector<std::string>(peer.begin(), peer.end()));
    EXPECT_TRUE(ring.empty());
}

}  // namespace
}  // namespace foverig
