#include "metrics/heatmap.h"

#include <gtest/gtest.h>

#include "metrics/flip.h"
#include "tests/metrics/expected.h"

namespace foverig::metrics {
namespace {

class HeatmapAgainstExpected : public test::Expected {};

TEST_F(HeatmapAgainstExpected, LooksAsTheMapThatTheFlipProgramWrote) {
    const Plane errors = flip(image("tree-ref.png"), image("tree-test.png"), 67.0206);
    const Image ours = heatmap(errors);
    const Image& theirs = image("tree-comparison-cli.png");
    ASSERT_EQ(ours.pixels.size(), theirs.pixels.size());
    // Three codes for the colours between ours, as their own tests allow; one or two for rounding.
    std::size_t off = 0;
    for (std::size_t i = 0; i < ours.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            off += std::abs(srgb_from_linear(ours.pixels[i][c]) -
                            srgb_from_linear(theirs.pixels[i][c])) > 5.0F / 255.0F
                       ? 1U
                       : 0U;
    EXPECT_LT(off, ours.pixels.size() / 1000);
}

TEST(Heatmap, GoesFromBlackToPaleYellow) {
    Plane errors(2, 1);
    errors.values = {0.0F, 1.0F};
    const Image map = heatmap(errors);
    EXPECT_LT(map.at(0, 0).x + map.at(0, 0).y, 1e-6F);
    EXPECT_NEAR(srgb_from_linear(map.at(1, 0).x) * 255.0F, 252.0F, 0.1F);
}

}  // namespace
}  // namespace foverig::metrics
