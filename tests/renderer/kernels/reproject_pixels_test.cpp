#include "renderer/kernels/reproject_pixels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "renderer/kernels/sampling.h"
#include "tests/renderer/kernels/mesh_arrays.h"

namespace foverig {
namespace {

constexpr int kWidth = 150;  // tiles of 64, 64 and 22 by 64 and 21 pixels
constexpr int kHeight = 85;
constexpr Half4 kOld{0x1234567890ABCDEFULL};
constexpr CacheInfo kOldInfo = 0xBEEFU;

std::size_t at(int x, int y) {
    return static_cast<std::size_t>(y * kWidth + x);
}

struct History {
    std::vector<Half4> colour = std::vector<Half4>(kWidth * kHeight, kOld);
    std::vector<CacheInfo> info = std::vector<CacheInfo>(kWidth * kHeight, kOldInfo);
    std::vector<Half4> light = std::vector<Half4>(kWidth * kHeight, kOld);

    HistoryImages images(bool with_light = true) {
        return {colour.data(), info.data(), with_light ? light.data() : nullptr};
    }
};

/// Any finite halves, every pixel its own.
History strewn() {
    History h;
    for (std::uint32_t i = 0; i < kWidth * kHeight; ++i) {
        const std::uint64_t bits = hash32(i, 1U) | std::uint64_t{hash32(i, 2U)} << 32U;
        h.colour[i] = {bits & 0xBFFFBFFFBFFFBFFFULL};  // no exponent of infinity or NaN
        h.info[i] = touched_in(hash32(i, 3U));
        h.light[i] = {(bits ^ 0x0F0F0F0F0F0F0F0FULL) & 0xBFFFBFFFBFFFBFFFULL};
    }
    return h;
}

/// Linear in the pixel, and exact in halves and in means of eight: red is x, green is y.
History ramp() {
    History h;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            h.colour[at(x, y)] =
                pack_half4({static_cast<float>(x), static_cast<float>(y), 0.0F, 2.0F});
            h.info[at(x, y)] = static_cast<CacheInfo>(at(x, y));
            h.light[at(x, y)] =
                pack_half4({static_cast<float>(x), static_cast<float>(y), 1.0F, 0.5F});
        }
    return h;
}

/// Where the mesh says a pixel's surface was, in px of the last image, and how it was covered.
struct Source {
    double x_px;
    double y_px;
    float magnification = 1.0F;
    bool covered = true;
};

/// Taps in footprints, by axis, tap and pixel of the 8x8 period.
struct Taps {
    explicit Taps(int taps) : offsets(static_cast<std::size_t>(taps) * 2 * 64) {}
    float& operator()(int tap, int axis, int x, int y) {
        return offsets[static_cast<std::size_t>(((tap * 2 + axis) * 8 + y % 8) * 8 + x % 8)];
    }
    std::vector<float> offsets;
};

/// All tiles of an image whose pixel (x, y) shows what the last image had at `source(x, y)`.
template <int kTaps, bool kLightBuffer = true, class SourceOf>
History reproject(History from, const Taps& taps, SourceOf&& source) {
    History to;
    for (int y0 = 0; y0 < kHeight; y0 += kRasterTile)
        for (int x0 = 0; x0 < kWidth; x0 += kRasterTile) {
            const int width = std::min(kRasterTile, kWidth - x0);
            const int height = std::min(kRasterTile, kHeight - y0);
            RasterArrays raster;
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    const Source s = source(x0 + x, y0 + y);
                    const std::size_t i = RasterArrays::index(x, y);
                    const double inverse_depth = 1.0 / (1.0 + (x + 3 * y) % 7);
                    raster.inverse_depth[i] = s.covered ? static_cast<float>(inverse_depth) : 0.0F;
                    raster.source_x_w[i] = static_cast<float>(s.x_px * inverse_depth);
                    raster.source_y_w[i] = static_cast<float>(s.y_px * inverse_depth);
                    raster.magnification[i] = s.magnification;
                }
            const ReprojectPixels<kTaps, kLightBuffer> kernel{raster.tile(),
                                                              {taps.offsets.data()},
                                                              from.images(kLightBuffer),
                                                              to.images(kLightBuffer),
                                                              x0,
                                                              y0,
                                                              width,
                                                              kWidth,
                                                              kHeight};
            for (int y = 0; y < height; ++y) kernel(y);
        }
    return to;
}

Source centre(int x, int y) {
    return {x + 0.5, y + 0.5};
}

bool same_pixel(const History& a, std::size_t i, const History& b, std::size_t j) {
    return a.colour[i].bits == b.colour[j].bits && a.info[i] == b.info[j] &&
           a.light[i].bits == b.light[j].bits;
}

TEST(ReprojectPixels, AStillEyeWithoutJitterSeesTheLastImageToTheBit) {
    const History last = strewn();
    const auto expect_same = [&](const History& now) {
        for (std::size_t i = 0; i < last.info.size(); ++i)
            ASSERT_TRUE(same_pixel(now, i, last, i)) << i;
    };
    expect_same(reproject<1>(last, Taps(1), centre));
    expect_same(reproject<2>(last, Taps(2), centre));
    expect_same(reproject<4>(last, Taps(4), centre));
    expect_same(reproject<8>(last, Taps(8), centre));
}

TEST(ReprojectPixels, AShiftByWholePixelsShiftsAndRepeatsTheBorder) {
    const History last = strewn();
    for (const auto& [dx, dy] : {std::pair{3, 0}, {0, -5}, {-70, 66}, {200, -200}}) {
        const History now = reproject<2>(last, Taps(2), [&, dx = dx, dy = dy](int x, int y) {
            return Source{x + dx + 0.5, y + dy + 0.5};
        });
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                ASSERT_TRUE(same_pixel(
                    now, at(x, y), last,
                    at(std::clamp(x + dx, 0, kWidth - 1), std::clamp(y + dy, 0, kHeight - 1))))
                    << x << ", " << y << " from " << dx << ", " << dy;
    }
}

TEST(ReprojectPixels, TakesTheTexelThatHoldsThePosition) {
    // Anywhere within a texel, and not the nearest corner.
    const History last = strewn();
    const History now = reproject<1>(last, Taps(1), [](int x, int y) {
        return Source{x + 0.0625 + 0.125 * (y % 8), y + 0.9375 - 0.125 * (x % 8)};
    });
    for (std::size_t i = 0; i < last.info.size(); ++i)
        ASSERT_TRUE(same_pixel(now, i, last, i)) << i;
}

TEST(ReprojectPixels, LeavesUncoveredPixelsAsTheyAre) {
    const auto covered = [](int x, int y) { return (3 * x + 5 * y) % 7 < 4; };
    const History last = strewn();
    const History untouched;
    const History now = reproject<2>(last, Taps(2), [&](int x, int y) {
        return Source{x + 0.5, y + 0.5, 1.0F, covered(x, y)};
    });
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            ASSERT_TRUE(same_pixel(now, at(x, y), covered(x, y) ? last : untouched, at(x, y)))
                << x << ", " << y;
}

/// Offsets that differ for every tap, axis and pixel of the period, up to 1.25 footprints: odd
/// multiples of 1/128, so that no tap of the footprints below lies within 1/256 px of an edge.
Taps strewn_taps(int count) {
    Taps taps(count);
    for (std::uint32_t i = 0; i < taps.offsets.size(); ++i)
        taps.offsets[i] = (2.0F * static_cast<float>(hash32(i, 7U) % 160U) - 159.0F) / 128.0F;
    return taps;
}

/// The position of one tap in double: the offset times the footprint's width, which is a pixel at
/// least and four at most.
int texel(double source_px, float offset, double magnification, int size_px) {
    const double width_px = std::clamp(std::sqrt(magnification), 1.0, 4.0);
    return static_cast<int>(
        std::floor(std::clamp(source_px + width_px * double{offset}, 0.0, size_px - 1.0)));
}

template <int kTaps>
void expect_mean_of_taps(float magnification) {
    SCOPED_TRACE(testing::Message() << kTaps << " taps, magnification " << magnification);
    Taps taps = strewn_taps(kTaps);
    const History last = ramp();
    const History now = reproject<kTaps>(last, taps, [&](int x, int y) {
        return Source{x + 0.5, y + 0.5, magnification};
    });
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            double mean_x = 0.0;
            double mean_y = 0.0;
            std::size_t first = 0;
            for (int k = 0; k < kTaps; ++k) {
                const int tx = texel(x + 0.5, taps(k, 0, x, y), double{magnification}, kWidth);
                const int ty = texel(y + 0.5, taps(k, 1, x, y), double{magnification}, kHeight);
                mean_x += double{1.0 / kTaps} * tx;
                mean_y += double{1.0 / kTaps} * ty;
                if (k == 0) first = at(tx, ty);
            }
            const std::size_t i = at(x, y);
            const vec4 shown = unpack_half4(now.colour[i]);
            ASSERT_EQ(shown,
                      vec4(static_cast<float>(mean_x), static_cast<float>(mean_y), 0.0F, 2.0F))
                << x << ", " << y;
            ASSERT_EQ(now.info[i], last.info[first]) << x << ", " << y;
            ASSERT_EQ(now.light[i].bits, last.light[first].bits) << x << ", " << y;
        }
}

TEST(ReprojectPixels, ColourIsTheMeanOfItsTapsInfoAndLightAreTheFirsts) {
    expect_mean_of_taps<1>(1.0F);
    expect_mean_of_taps<2>(1.0F);
    expect_mean_of_taps<4>(1.0F);
    expect_mean_of_taps<8>(1.0F);
}

TEST(ReprojectPixels, TapsSpreadWithTheFootprintFromOnePixelToFour) {
    for (const float magnification : {0.01F, 0.5F, 2.25F, 6.25F, 16.0F, 25.0F, 1.0e6F})
        expect_mean_of_taps<2>(magnification);
}

TEST(ReprojectPixels, SymmetricTapsKeepAMagnifiedRamp) {
    // Seen from nearer by: four new pixels on each old one. Inside, the ramp's own value.
    Taps taps(2);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            for (const int axis : {0, 1}) {
                taps(0, axis, x, y) = 3.0F;
                taps(1, axis, x, y) = -3.0F;
            }
    const History now = reproject<2>(ramp(), taps, [](int x, int y) {
        return Source{20.0 + (x + 0.5) / 4.0, 20.0 + (y + 0.5) / 4.0, 1.0F / 16.0F};
    });
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const vec4 shown = unpack_half4(now.colour[at(x, y)]);
            const int old_x = 20 + x / 4;
            const int old_y = 20 + y / 4;
            ASSERT_EQ(shown.x, static_cast<float>(old_x)) << x;
            ASSERT_EQ(shown.y, static_cast<float>(old_y)) << y;
        }
}

TEST(ReprojectPixels, WithoutALightBufferColourAndInfoAreTheSame) {
    const History with = reproject<4, true>(strewn(), strewn_taps(4), centre);
    const History without = reproject<4, false>(strewn(), strewn_taps(4), centre);
    for (std::size_t i = 0; i < with.info.size(); ++i) {
        ASSERT_EQ(with.colour[i].bits, without.colour[i].bits);
        ASSERT_EQ(with.info[i], without.info[i]);
        ASSERT_EQ(without.light[i].bits, kOld.bits);
    }
}

}  // namespace
}  // namespace foverig
