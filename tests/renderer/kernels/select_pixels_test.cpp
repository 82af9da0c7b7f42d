#include "renderer/kernels/select_pixels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

namespace foverig {
namespace {

constexpr int kTile = 64;
constexpr std::uint8_t kUntouched = 0xA5;
constexpr double kPerDeg = 0.017453292519943295;

EyeView asymmetric_eye() {
    EyeView view{160, 120};
    view.tan_left = 1.25F;
    view.tan_right = 0.75F;
    view.tan_down = 1.0F;
    view.tan_up = 0.875F;
    return view;
}

/// Direction of gaze that many degrees to the right of straight ahead and upward.
dvec3 gaze_at(double right_deg, double up_deg) {
    return {std::sin(right_deg * kPerDeg) * std::cos(up_deg * kPerDeg), std::sin(up_deg * kPerDeg),
            -std::cos(right_deg * kPerDeg) * std::cos(up_deg * kPerDeg)};
}

/// A whole image of flags, selected tile by tile.
struct Selection {
    EyeView view = asymmetric_eye();
    FovealFunction foveal{10.0, 30.0, 0.125};
    dvec3 gaze = gaze_at(-12.0, 9.0);
    CoarseLookup resampled{};
    std::vector<std::int16_t> support_column = std::vector<std::int16_t>(160, -1);
    std::vector<std::int16_t> support_row = std::vector<std::int16_t>(120, -1);

    std::vector<std::uint8_t> flags(std::uint32_t frame_seed,
                                    TileZone zone = TileZone::falloff) const {
        std::vector<std::uint8_t> image;
        image.resize(static_cast<std::size_t>(view.width_px * view.height_px));
        std::vector<std::uint8_t> tile(kTile * kTile);
        for (int y0 = 0; y0 < view.height_px; y0 += kTile)
            for (int x0 = 0; x0 < view.width_px; x0 += kTile) {
                const int width = std::min(kTile, view.width_px - x0);
                const int height = std::min(kTile, view.height_px - y0);
                std::fill(tile.begin(), tile.end(), kUntouched);
                const SelectPixels select{foveal,
                                          EyeRays(view),
                                          vec3(gaze),
                                          frame_seed,
                                          resampled,
                                          support_column.data(),
                                          support_row.data(),
                                          zone,
                                          x0,
                                          y0,
                                          width,
                                          tile.data()};
                for (int y = 0; y < height; ++y) select(y);
                for (int y = 0; y < kTile; ++y)
                    for (int x = 0; x < kTile; ++x) {
                        const std::uint8_t flag = tile[static_cast<std::size_t>(y * kTile + x)];
                        if (x < width && y < height)
                            image[at(x0 + x, y0 + y)] = flag;
                        else
                            EXPECT_EQ(flag, kUntouched) << "beyond the tile";
                    }
            }
        return image;
    }
    std::size_t at(int x, int y) const { return static_cast<std::size_t>(y * view.width_px + x); }

    /// Of a pixel's centre, in double.
    double eccentricity_deg(int x, int y) const {
        const double right = (x + 0.5) / view.width_px * double{view.tan_left + view.tan_right} -
                             double{view.tan_left};
        const double down =
            (y + 0.5) / view.height_px * double{view.tan_up + view.tan_down} - double{view.tan_up};
        const double along = right * gaze.x - down * gaze.y - gaze.z;
        return std::acos(along / std::sqrt(right * right + down * down + 1.0)) / kPerDeg;
    }
    template <class F>
    void for_pixels(F&& f) const {
        for (int y = 0; y < view.height_px; ++y)
            for (int x = 0; x < view.width_px; ++x) f(x, y);
    }
};

/// How many were chosen of how many, with the mean and variance that their probabilities give.
struct Count {
    double chosen = 0.0;
    double expected = 0.0;
    double variance = 0.0;

    void add(bool is_chosen, double p) {
        chosen += is_chosen ? 1.0 : 0.0;
        expected += p;
        variance += p * (1.0 - p);
    }
    void expect_binomial() const {  // five sigma: one draw of two million strays further
        EXPECT_GT(expected, 100.0);
        EXPECT_NEAR(chosen, expected, 5.0 * std::sqrt(variance) + 0.01 * std::sqrt(expected));
    }
};

/// Bounds rounding of the ray, the gaze and the fast angle: pixels this near r0 may go either way.
constexpr double kEdge_deg = 1.0e-3;

TEST(SelectPixels, EveryFovealPixelIsChosenAndNoOtherIsFoveal) {
    const Selection s;
    const auto flags = s.flags(17U);
    int inside = 0;
    s.for_pixels([&](int x, int y) {
        const double e_deg = s.eccentricity_deg(x, y);
        if (std::abs(e_deg - 10.0) < kEdge_deg) return;
        const std::uint8_t flag = flags[s.at(x, y)];
        if (e_deg < 10.0) {
            EXPECT_EQ(flag, kFovealSample | kChosenSample) << x << ", " << y;
            ++inside;
        } else {
            EXPECT_EQ(flag & ~kChosenSample, 0) << x << ", " << y;
        }
    });
    EXPECT_GT(inside, 300);
}

TEST(SelectPixels, ProbabilityFallsLinearlyFromR0ToR1AndStaysThere) {
    // p(q) of Weier 2016 figure 3 in double, summed over rings of two degrees and forty frames.
    const Selection s;
    std::vector<Count> rings(30);
    for (std::uint32_t frame = 0; frame < 40; ++frame) {
        const auto flags = s.flags(hash32(frame));
        s.for_pixels([&](int x, int y) {
            const double e_deg = s.eccentricity_deg(x, y);
            const double p =
                1.0 - (1.0 - 0.125) * std::clamp((e_deg - 10.0) / (30.0 - 10.0), 0.0, 1.0);
            const auto ring = static_cast<std::size_t>(e_deg / 2.0);
            if (ring < rings.size()) rings[ring].add((flags[s.at(x, y)] & kChosenSample) != 0, p);
        });
    }
    for (std::size_t i = 0; i < rings.size(); ++i) {
        SCOPED_TRACE(testing::Message() << 2 * i << " degrees");
        rings[i].expect_binomial();
    }
}

TEST(SelectPixels, FramesAndNeighboursAreDrawnIndependently) {
    // Pairs of pixels of a uniform image that are chosen together: p^2 of all.
    Selection s;
    s.foveal = FovealFunction(10.0, 30.0, 0.25);
    Count beside, below, diagonal, next_frame;
    auto last = s.flags(hash32(999U), TileZone::peripheral);
    for (std::uint32_t frame = 0; frame < 20; ++frame) {
        const auto flags = s.flags(hash32(1000U + frame), TileZone::peripheral);
        const auto chosen = [&](int x, int y) { return flags[s.at(x, y)] != 0; };
        s.for_pixels([&](int x, int y) {
            next_frame.add(chosen(x, y) && last[s.at(x, y)] != 0, 0.0625);
            if (x % 2 != 0 || y % 2 != 0) return;  // no pixel in two pairs of one count
            beside.add(chosen(x, y) && chosen(x + 1, y), 0.0625);
            below.add(chosen(x, y) && chosen(x, y + 1), 0.0625);
            diagonal.add(chosen(x, y) && chosen(x + 1, y + 1), 0.0625);
        });
        last = flags;
    }
    for (const Count& pairs : {beside, below, diagonal, next_frame}) pairs.expect_binomial();
}

TEST(SelectPixels, ATileOfOneZoneNeedsNoAngle) {
    const Selection s;
    for (const std::uint8_t flag : s.flags(5U, TileZone::foveal))
        ASSERT_EQ(flag, kFovealSample | kChosenSample);
    Count count;
    for (const std::uint8_t flag : s.flags(5U, TileZone::peripheral)) {
        ASSERT_EQ(flag & ~kChosenSample, 0);
        count.add(flag != 0, 0.125);
    }
    count.expect_binomial();
}

TEST(SelectPixels, AZoneChangesNoDraw) {
    // Where no pixel lies inside r1, the peripheral tile is the falloff tile without its angles.
    Selection s;
    s.gaze = gaze_at(130.0, 0.0);
    EXPECT_EQ(s.flags(6U, TileZone::falloff), s.flags(6U, TileZone::peripheral));
}

TEST(SelectPixels, NoLeastProbabilityChoosesNothingOutside) {
    Selection s;
    s.foveal = FovealFunction(10.0, 10.0, 0.0);  // and r0 = r1 is a step
    const auto flags = s.flags(21U);
    s.for_pixels([&](int x, int y) {
        const double e_deg = s.eccentricity_deg(x, y);
        if (std::abs(e_deg - 10.0) < kEdge_deg) return;
        EXPECT_EQ(flags[s.at(x, y)], e_deg < 10.0 ? kFovealSample | kChosenSample : 0);
    });
}

TEST(SelectPixels, FullLeastProbabilityChoosesAll) {
    Selection s;
    s.foveal = FovealFunction(10.0, 30.0, 1.0);
    for (const TileZone zone : {TileZone::falloff, TileZone::peripheral})
        for (const std::uint8_t flag : s.flags(22U, zone)) ASSERT_NE(flag & kChosenSample, 0);
}

TEST(SelectPixels, AGazeOffTheImageLeavesItsRingsOnIt) {
    // 50 degrees to the right, where the image ends at 37: the foveal circle does not reach it.
    Selection s;
    s.gaze = gaze_at(50.0, 0.0);
    Count near, far;
    for (std::uint32_t frame = 0; frame < 40; ++frame) {
        const auto flags = s.flags(hash32(frame));
        s.for_pixels([&](int x, int y) {
            const std::uint8_t flag = flags[s.at(x, y)];
            EXPECT_EQ(flag & kFovealSample, 0);
            const double e_deg = s.eccentricity_deg(x, y);
            const bool inside = e_deg < 30.0;
            (inside ? near : far)
                .add(flag != 0, inside ? 1.0 - 0.875 * (e_deg - 10.0) / 20.0 : 0.125);
        });
    }
    near.expect_binomial();
    far.expect_binomial();
}

TEST(SelectPixels, AGazeBehindTheHeadSeesNoFovea) {
    Selection s;
    s.gaze = gaze_at(180.0 - 12.0, -9.0);  // opposite a pixel of the image
    Count count;
    for (const std::uint8_t flag : s.flags(31U)) {
        EXPECT_EQ(flag & kFovealSample, 0);
        count.add(flag != 0, 0.125);
    }
    count.expect_binomial();
}

TEST(SelectPixels, TheTurnedHeadSeesTheSame) {
    // Eye and gaze turned together, a quarter about y: x' = z, z' = -x.
    const Selection straight;
    Selection turned;
    turned.view.world_from_eye = mat3(vec3(0, 0, -1), vec3(0, 1, 0), vec3(1, 0, 0));
    turned.gaze = {straight.gaze.z, straight.gaze.y, -straight.gaze.x};
    EXPECT_EQ(straight.flags(8U), turned.flags(8U));
}

TEST(SelectPixels, MarkedCellsAndSupportPixelsAreAddedToWhatIsDrawn) {
    Selection s;
    const auto drawn = s.flags(41U);
    std::vector<std::uint8_t> marked(16 * 8, 0);  // cells of 10 by 15 pixels
    for (const int cell : {0, 15, 53, 6 * 16 + 6, 127}) marked[static_cast<std::size_t>(cell)] = 1;
    std::vector<std::int16_t> column_of, row_of;
    for (int x = 0; x < 160; ++x) column_of.push_back(static_cast<std::int16_t>(x / 10));
    for (int y = 0; y < 120; ++y) row_of.push_back(static_cast<std::int16_t>(y / 15));
    s.resampled.marked = marked.data();
    s.resampled.column_of = column_of.data();
    s.resampled.row_of = row_of.data();
    s.resampled.columns = 16;
    s.resampled.rows = 8;
    for (const int x : {0, 53, 63, 64, 106, 159}) s.support_column[static_cast<std::size_t>(x)] = 0;
    for (const int y : {0, 40, 63, 64, 119}) s.support_row[static_cast<std::size_t>(y)] = 3;
    const auto flags = s.flags(41U);
    const auto one_of = [](int p, std::initializer_list<int> of) {
        return std::find(of.begin(), of.end(), p) != of.end();
    };
    s.for_pixels([&](int x, int y) {
        const int cell = y / 15 * 16 + x / 10;
        const bool resampled = one_of(cell, {0, 15, 53, 102, 127});
        const bool support =
            one_of(x, {0, 53, 63, 64, 106, 159}) && one_of(y, {0, 40, 63, 64, 119});
        EXPECT_EQ(flags[s.at(x, y)],
                  drawn[s.at(x, y)] | (resampled ? kResampled : 0) | (support ? kSupportSample : 0))
            << x << ", " << y;
    });
}

}  // namespace
}  // namespace foverig
