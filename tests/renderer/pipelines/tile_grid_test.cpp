#include "renderer/kernels/tile_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace foverig {
namespace {

TEST(CoherentOrder, IsAPermutationOfTheTilesPixels) {
    const std::set<std::uint16_t> seen(kCoherentOrder.begin(), kCoherentOrder.end());
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(kTilePixels));
    EXPECT_EQ(*seen.rbegin(), kTilePixels - 1);
}

TEST(CoherentOrder, SixteenInARowAreAFourByFourBlock) {
    for (std::size_t first = 0; first < kCoherentOrder.size(); first += 16) {
        std::set<std::pair<int, int>> blocks;
        for (std::size_t i = first; i < first + 16; ++i)
            blocks.insert({kCoherentOrder[i] % kTile / 4, kCoherentOrder[i] / kTile / 4});
        EXPECT_EQ(blocks.size(), 1U);
    }
}

TEST(TileGrid, RectsCoverEveryPixelExactlyOnce) {
    for (const auto& [width, height] : {std::pair{1, 1}, std::pair{64, 64}, std::pair{65, 63},
                                        std::pair{320, 396}, std::pair{1182, 1464}}) {
        const TileGrid grid{width, height};
        std::vector<int> count(static_cast<std::size_t>(width * height));
        for (int tile = 0; tile < grid.count(); ++tile) {
            const TileRect r = grid.rect(tile);
            ASSERT_TRUE(r.width > 0 && r.width <= kTile && r.height > 0 && r.height <= kTile);
            for (int y = r.y0; y < r.y0 + r.height; ++y)
                for (int x = r.x0; x < r.x0 + r.width; ++x)
                    ++count[static_cast<std::size_t>(y * width + x)];
        }
        EXPECT_EQ(std::count(count.begin(), count.end(), 1), width * height);
    }
}

}  // namespace
}  // namespace foverig
