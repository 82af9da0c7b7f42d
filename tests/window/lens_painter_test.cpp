// The lens on the graphics card against the lens pass on the CPU, and the late warp against
// geometry.
#include "devices/window/lens_painter.h"

#include <gtest/gtest.h>

#include "devices/window/window.h"
#include "rig/session/lens_pass.h"
#include "tests/window/pictures.h"
#include "tests/window/xvfb.h"

namespace foverig {
namespace {

using test::HalfPicture;
using test::Shot;

const std::array<dmat3, 2> kNoWarp{dmat3(1.0), dmat3(1.0)};
const PanelView kPanel({1920, 1080}, false);

class LensPainterTest : public test::OnADesktop {
  protected:
    void open(bool lens = true) {
        auto window = window::Window::open({.size = {1920, 1080}});
        ASSERT_TRUE(window) << window.error().text;
        window_ = std::move(window).value();
        auto painter = window::LensPainter::make(EyeMap(lens));
        ASSERT_TRUE(painter) << painter.error().text;
        painter_.emplace(std::move(painter).value());
    }
    Shot painted(const Image& left, const Image& right,
                 const std::array<dmat3, 2>& warp = kNoWarp) {
        painter_->fill(Eye::left, HalfPicture(left).view());
        painter_->fill(Eye::right, HalfPicture(right).view());
        painter_->paint(kPanel, 2, warp);
        return test::shot_of_framebuffer(1920, 1080);
    }

    std::unique_ptr<window::Window> window_;
    std::optional<window::LensPainter> painter_;
};

int level_of(float linear) {
    return static_cast<int>(std::lround(255.0F * srgb_from_linear(std::clamp(linear, 0.0F, 1.0F))));
}

// 8 bit, a mesh of straight pieces (0.05 px) and a filter of 8 bit weights on one side; a pixel at
// the picture's very edge may fall to either side of it.
constexpr double kMeanTolerance = 0.05;  // levels of 255
constexpr int kPixelTolerance = 3;       // levels, but for
constexpr double kEdgeShare = 0.0002;    // of the pixels

TEST_F(LensPainterTest, AgreesWithTheLensPassOnTheCpu) {
    ASSERT_NO_FATAL_FAILURE(open());
    const std::vector<Image> eyes{test::waves(0), test::waves(1)};
    Scenario s;
    s.display.eye_width_px = test::kEyeWidth_px;
    s.display.eye_height_px = test::kEyeHeight_px;
    const Image expected = LensPass(s).picture(eyes);
    const Shot shot = painted(eyes[0], eyes[1]);
    test::keep(shot, "lens");
    double sum = 0.0;
    std::size_t beyond = 0;
    for (int y = 0; y < 1080; ++y) {
        for (int x = 0; x < 1920; ++x) {
            for (int c = 0; c < 3; ++c) {
                const int error = std::abs(shot.at(x, y)[c] - level_of(expected.at(x, y)[c]));
                sum += error;
                if (error > kPixelTolerance) ++beyond;
            }
        }
    }
    constexpr double kValues = 3.0 * 1920 * 1080;
    RecordProperty("mean_levels", std::to_string(sum / kValues));
    RecordProperty("share_beyond", std::to_string(static_cast<double>(beyond) / kValues));
    EXPECT_LT(sum / kValues, kMeanTolerance);
    EXPECT_LT(static_cast<double>(beyond) / kValues, kEdgeShare);
}

/// Mean place of green light, panel pixels from the upper left.
dvec2 centre_of_light(const Shot& shot, int from_x, int to_x) {
    dvec2 sum(0.0);
    double weight = 0.0;
    for (int y = 0; y < shot.height_px; ++y) {
        for (int x = from_x; x < to_x; ++x) {
            const double light = static_cast<double>(
                linear_from_srgb(static_cast<float>(shot.at(x, y)[1]) / 255.0F));
            sum += light * dvec2(x + 0.5, y + 0.5);
            weight += light;
        }
    }
    return sum / weight;
}

/// A small spot of light in one direction, round in the picture.
Image spot(Eye eye, const dvec3& direction) {
    const TangentFrustum f = Dk2Optics().frustum(eye);
    const dvec2 tangent = dvec2(direction.x, direction.y) / -direction.z;
    const dvec2 at{(tangent.x + f.left) / (f.left + f.right) * test::kEyeWidth_px,
                   (f.up - tangent.y) / (f.up + f.down) * test::kEyeHeight_px};
    Image image{test::kEyeWidth_px, test::kEyeHeight_px, {}};
    for (int y = 0; y < image.height_px; ++y) {
        for (int x = 0; x < image.width_px; ++x) {
            const dvec2 d = dvec2(x + 0.5, y + 0.5) - at;
            image.pixels.emplace_back(static_cast<float>(std::exp(-glm::dot(d, d) / 8.0)));
        }
    }
    return image;
}

constexpr double kSpotTolerance_px = 0.25;  // its centre, of 8 bit levels, seen through the lens

TEST_F(LensPainterTest, LateWarpMovesTheWorldByTheHeadsTurn) {
    ASSERT_NO_FATAL_FAILURE(open());
    const dvec3 seen = glm::normalize(dvec3(0.10, 0.20, -1.0));
    const Dk2Optics optics;
    // The head turned on after the picture was rendered: yaw, pitch and roll, 1 to 6 degrees.
    for (const dvec3& turn_deg :
         {dvec3(0.0), dvec3(0.0, 3.0, 0.0), dvec3(-4.0, 0.0, 0.0), dvec3(1.0, -5.0, 6.0)}) {
        const dquat rendered(glm::radians(dvec3(5.0, 40.0, -3.0)));
        const dquat newest = rendered * dquat(glm::radians(turn_deg));
        const dmat3 warp = glm::mat3_cast(glm::conjugate(rendered) * newest);
        const Shot shot = painted(spot(Eye::left, seen), spot(Eye::right, seen), {warp, warp});
        // The spot stands in the world: the new head sees it elsewhere.
        const dvec3 now = glm::conjugate(newest) * (rendered * seen);
        const dvec2 tangent = dvec2(now.x, now.y) / -now.z;
        for (const Eye eye : {Eye::left, Eye::right}) {
            const int from_x = eye == Eye::left ? 0 : 960;
            const dvec2 at = centre_of_light(shot, from_x, from_x + 960);
            const dvec2 expected = kPanel.at_px({eye, optics.ndc(eye, tangent)});
            EXPECT_NEAR(at.x, expected.x, kSpotTolerance_px) << turn_deg.x << " " << turn_deg.y;
            EXPECT_NEAR(at.y, expected.y, kSpotTolerance_px) << turn_deg.x << " " << turn_deg.y;
        }
    }
}

TEST_F(LensPainterTest, AYawOfOneDegreeIsTheCentresPixelsPerDegree) {
    ASSERT_NO_FATAL_FAILURE(open());
    const dvec3 ahead(0.0, 0.0, -1.0);
    const dmat3 yaw = glm::mat3_cast(dquat(dvec3(0.0, glm::radians(1.0), 0.0)));
    const dvec2 before =
        centre_of_light(painted(spot(Eye::left, ahead), spot(Eye::right, ahead)), 0, 960);
    const dvec2 after = centre_of_light(
        painted(spot(Eye::left, ahead), spot(Eye::right, ahead), {yaw, yaw}), 0, 960);
    // A head that turns left sees the world move right: 9.593 px a degree (DEVICES.md 2.2).
    EXPECT_NEAR(after.x - before.x, 9.593, 0.1);
    EXPECT_NEAR(after.y - before.y, 0.0, 0.05);
}

TEST_F(LensPainterTest, WithoutALensAPictureFillsItsHalf) {
    ASSERT_NO_FATAL_FAILURE(open(false));
    Image left = test::waves(0);
    for (vec3& pixel : left.pixels) pixel = vec3(1.0F, 0.0F, 0.0F);
    Image right = left;
    for (vec3& pixel : right.pixels) pixel = vec3(0.0F, 0.0F, 1.0F);
    const Shot shot = painted(left, right);
    for (const auto& [x, y] : {std::pair{0, 0}, {959, 0}, {0, 1079}, {959, 1079}, {480, 540}}) {
        EXPECT_EQ(shot.at(x, y)[0], 255);
        EXPECT_EQ(shot.at(x, y)[2], 0);
        EXPECT_EQ(shot.at(960 + x, y)[0], 0);
        EXPECT_EQ(shot.at(960 + x, y)[2], 255);
    }
}

TEST_F(LensPainterTest, APictureOnTheGraphicsCardNeedsNoHost) {
    ASSERT_NO_FATAL_FAILURE(open());
    const Image image = test::waves(0);
    const Shot expected = painted(image, image);
    const HalfPicture pixels(test::waves(1));
    const HalfPicture same(image);
    EyePicture picture = pixels.view();
    picture.half_rgba = []() -> std::span<const std::byte> {
        ADD_FAILURE() << "the host was asked";
        return {};
    };
    picture.copy_to_texture = [&](unsigned int texture) {
        glBindTexture(GL_TEXTURE_2D, texture);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, image.width_px, image.height_px, GL_RGBA,
                        GL_HALF_FLOAT, same.view().half_rgba().data());
        return true;
    };
    for (const Eye eye : {Eye::left, Eye::right}) painter_->fill(eye, picture);
    painter_->paint(kPanel, 2, kNoWarp);
    EXPECT_EQ(test::shot_of_framebuffer(1920, 1080).rgb, expected.rgb);
    // A way that fails leaves the host's.
    picture = same.view();
    picture.copy_to_texture = [](unsigned int) { return false; };
    for (const Eye eye : {Eye::left, Eye::right}) painter_->fill(eye, picture);
    painter_->paint(kPanel, 2, kNoWarp);
    EXPECT_EQ(test::shot_of_framebuffer(1920, 1080).rgb, expected.rgb);
}

TEST_F(LensPainterTest, LeavesTheHalfOfAMissingEyeBlack) {
    ASSERT_NO_FATAL_FAILURE(open());
    painter_->fill(Eye::left, HalfPicture(test::waves(0)).view());
    painter_->paint(kPanel, 1, kNoWarp);
    const Shot shot = test::shot_of_framebuffer(1920, 1080);
    EXPECT_GT(shot.at(480, 540)[1], 0);
    EXPECT_EQ(shot.at(1440, 540)[0] + shot.at(1440, 540)[1] + shot.at(1440, 540)[2], 0);
}

// DEVICES.md 1.7, 2.3: the portrait scan's first row is the landscape's right edge, and its upper
// left corner the landscape's upper right.
TEST_F(LensPainterTest, APortraitPanelGetsTheLandscapeOnItsSide) {
    ASSERT_NO_FATAL_FAILURE(open());
    const Image left = test::waves(0), right = test::waves(1);
    const Shot landscape = painted(left, right);
    const test::Canvas canvas(1080, 1920);
    painter_->paint(PanelView({1080, 1920}, true), 2, kNoWarp);
    const Shot portrait = test::shot_of_framebuffer(1080, 1920);
    test::keep(portrait, "portrait");
    std::size_t beyond = 0;
    for (int y = 0; y < 1920; ++y)
        for (int x = 0; x < 1080; ++x)
            for (int c = 0; c < 3; ++c)
                if (std::abs(portrait.at(x, y)[c] - landscape.at(1919 - y, x)[c]) > 1) ++beyond;
    EXPECT_LT(static_cast<double>(beyond), kEdgeShare * 3.0 * 1920 * 1080);
}

}  // namespace
}  // namespace foverig
