#include "devices/camera/blobs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace foverig::camera {
namespace {

/// A dark image with Gaussian spots, each pixel its own rounding.
class Picture {
  public:
    explicit Picture(int dark = 10) : bytes_(kWidth * kHeight, static_cast<std::byte>(dark)) {}

    void spot(double x, double y, double peak, double sigma_px) {
        for (int py = 0; py < kHeight; ++py) {
            for (int px = 0; px < kWidth; ++px) {
                const double r2 = (px - x) * (px - x) + (py - y) * (py - y);
                const double light = peak * std::exp(-0.5 * r2 / (sigma_px * sigma_px));
                auto& b = bytes_[static_cast<std::size_t>(py * kWidth + px)];
                b = static_cast<std::byte>(
                    std::min(255, static_cast<int>(std::lround(std::to_integer<int>(b) + light))));
            }
        }
    }
    void box(int left, int top, int width, int height) {
        for (int y = top; y < top + height; ++y) {
            for (int x = left; x < left + width; ++x) {
                bytes_[static_cast<std::size_t>(y * kWidth + x)] = std::byte{255};
            }
        }
    }
    GreyView view() const { return {kWidth, kHeight, kWidth, bytes_}; }

  private:
    static constexpr int kWidth = 160, kHeight = 120;
    std::vector<std::byte> bytes_;
};

double worst_error_px(double peak, double sigma_px) {
    double worst = 0;
    for (int i = 0; i < 50; ++i) {
        const dvec2 truth(60 + 0.13 * i, 50 + 0.29 * i);
        Picture picture;
        picture.spot(truth.x, truth.y, peak, sigma_px);
        const auto blobs = find_blobs(picture.view());
        if (blobs.size() != 1) return 1e9;
        worst = std::max(worst, glm::distance(blobs[0].center_px, truth));
    }
    return worst;
}

// Seen: 0.035 px where the peak is ten times what a pixel can hold, less elsewhere.
TEST(Blobs, CentresAreRightToAFractionOfAPixel) {
    EXPECT_LT(worst_error_px(200, 1.0), 0.02);
    EXPECT_LT(worst_error_px(40, 1.0), 0.06);
    EXPECT_LT(worst_error_px(200, 2.5), 0.02);
    EXPECT_LT(worst_error_px(2000, 1.0), 0.05);
}

TEST(Blobs, BrightnessTellsBrightFromDim) {
    Picture picture;
    picture.spot(40.3, 40.6, 100, 1.0);
    picture.spot(100.2, 41.9, 200, 1.0);
    const auto blobs = find_blobs(picture.view());
    ASSERT_EQ(blobs.size(), 2u);
    const auto [dim, bright] = std::minmax(blobs[0].brightness, blobs[1].brightness);
    EXPECT_NEAR(bright / dim, 2.0, 0.1);
}

TEST(Blobs, NeighboursTakeNoLightOfEachOther) {
    Picture picture;
    picture.spot(60.0, 60.0, 60, 1.0);
    picture.spot(67.0, 60.0, 220, 1.0);
    const auto blobs = find_blobs(picture.view());
    ASSERT_EQ(blobs.size(), 2u);
    for (const Blob& b : blobs) {
        EXPECT_LT(std::min(std::abs(b.center_px.x - 60.0), std::abs(b.center_px.x - 67.0)), 0.1);
    }
}

TEST(Blobs, LampsEdgesAndWhatLeavesTheImageAreNone) {
    Picture picture;
    picture.box(20, 20, 40, 40);  // a window
    picture.box(80, 10, 30, 2);   // a tube
    picture.spot(0.5, 90, 200, 1.0);
    picture.spot(120, 119, 200, 1.0);
    EXPECT_TRUE(find_blobs(picture.view()).empty());
    EXPECT_TRUE(find_blobs(Picture(250).view()).empty());
}

TEST(Blobs, RegionsThatMeetBelowAreOne) {
    Picture picture;
    picture.box(30, 30, 2, 6);
    picture.box(36, 30, 2, 6);
    picture.box(30, 36, 8, 2);
    const auto blobs = find_blobs(picture.view(), {.least_fill = 0.1});
    ASSERT_EQ(blobs.size(), 1u);
    EXPECT_EQ(blobs[0].area_px, 12 + 12 + 16);
    EXPECT_NEAR(blobs[0].center_px.x, 33.5, 1e-6);
}

}  // namespace
}  // namespace foverig::camera
