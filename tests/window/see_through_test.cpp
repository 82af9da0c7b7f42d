// A camera's picture behind the rendered one, on the graphics card: where it shows, where not, and
// how it turns with the head.
#include <gtest/gtest.h>

#include "devices/window/lens_painter.h"
#include "devices/window/window.h"
#include "tests/window/pictures.h"
#include "tests/window/xvfb.h"

namespace foverig {
namespace {

using test::HalfPicture;
using test::Shot;

const PanelView kPanel({960, 540}, false);
const dvec3 kUp(0, 1, 0);

/// All of an eye's picture.
Image filled(const vec3& colour) {
    Image image{test::kEyeWidth_px, test::kEyeHeight_px, {}};
    image.pixels.assign(static_cast<std::size_t>(image.width_px) * image.height_px, colour);
    return image;
}

Image nothing() {
    return filled({kNothingMet[0], kNothingMet[1], kNothingMet[2]});
}

/// Red grows with the tangent to the right, green upwards, from 0 to 255 over the picture.
struct Gradient {
    static constexpr int kSize_px = 256;
    static constexpr double kTanHalf = 1.5;
    std::vector<std::uint8_t> rgb;

    Gradient() {
        for (int y = 0; y < kSize_px; ++y) {
            for (int x = 0; x < kSize_px; ++x) {
                rgb.insert(rgb.end(), {static_cast<std::uint8_t>(x),
                                       static_cast<std::uint8_t>(255 - y), std::uint8_t{80}});
            }
        }
    }
    BehindPicture view() const {
        const double fov_deg = glm::degrees(2.0 * std::atan(kTanHalf));
        return {.width_px = kSize_px,
                .height_px = kSize_px,
                .srgb = rgb,
                .lens = camera::ideal_lens(kSize_px, kSize_px, fov_deg)};
    }
    /// The level at a tangent: of pixel centres.
    static double level(double tangent) { return 128.0 * (tangent / kTanHalf + 1.0) - 0.5; }
};

class SeeThroughTest : public test::OnADesktop {
  protected:
    void SetUp() override {
        auto window = window::Window::open({.size = {960, 540}});
        ASSERT_TRUE(window) << window.error().text;
        window_ = std::move(window).value();
        auto painter = window::LensPainter::make(map_, true);
        ASSERT_TRUE(painter) << painter.error().text;
        painter_.emplace(std::move(painter).value());
    }
    Shot painted(const Image& eye, const dquat& newest = {1, 0, 0, 0},
                 const dquat& rendered = {1, 0, 0, 0}) {
        return painted(eye, camera_.view(), newest, rendered);
    }
    Shot painted(const Image& eye, const BehindPicture& behind, const dquat& newest = {1, 0, 0, 0},
                 const dquat& rendered = {1, 0, 0, 0}) {
        painter_->fill(Eye::left, HalfPicture(eye).view());
        painter_->fill(Eye::right, HalfPicture(eye).view());
        painter_->fill(behind);
        const dmat3 warp = glm::mat3_cast(glm::conjugate(rendered) * newest);
        const dmat3 turned = glm::mat3_cast(newest);  // the camera looked straight ahead
        painter_->paint(kPanel, 2, {warp, warp}, std::array{turned, turned});
        return test::shot_of_framebuffer(960, 540);
    }
    /// Where a direction lies on the left eye's half.
    dvec2 place_px(const dvec3& direction) const {
        return kPanel.at_px(
            {Eye::left, map_.ndc(Eye::left, dvec2(direction.x, direction.y) / -direction.z)});
    }

    EyeMap map_{true};
    Gradient camera_;
    std::unique_ptr<window::Window> window_;
    std::optional<window::LensPainter> painter_;
};

void expect_camera(const Shot& shot, const dvec2& at_px, const dvec3& in_camera) {
    const std::uint8_t* p = shot.at(static_cast<int>(at_px.x), static_cast<int>(at_px.y));
    EXPECT_NEAR(p[0], Gradient::level(in_camera.x / -in_camera.z), 3.0);
    EXPECT_NEAR(p[1], Gradient::level(in_camera.y / -in_camera.z), 3.0);
    EXPECT_NEAR(p[2], 80, 2);
}

constexpr std::array kDirections{dvec3(0.0, 0.0, -1.0), dvec3(0.3, 0.2, -1.0),
                                 dvec3(-0.4, -0.3, -1.0), dvec3(0.1, -0.5, -1.0)};

TEST_F(SeeThroughTest, ShowsTheCameraWhereNothingWasMet) {
    const Shot shot = painted(nothing());
    test::keep(shot, "see_through");
    for (const dvec3& d : kDirections) expect_camera(shot, place_px(d), d);
}

// Lens::project is held to OpenCV's in its own test. Beyond the fold (1.05 here) nothing is seen.
TEST_F(SeeThroughTest, ALensPutsEachDirectionWhereItSeesIt) {
    const camera::Lens lens{.fx_px = 150.0,
                            .fy_px = 140.0,
                            .cx_px = 120.0,
                            .cy_px = 134.0,
                            .k1 = -0.3,
                            .p1 = 0.004,
                            .p2 = -0.003};
    BehindPicture behind = camera_.view();
    behind.lens = lens;
    const Shot shot = painted(nothing(), behind);
    test::keep(shot, "see_through_lens");
    for (const dvec3& d : kDirections) {
        const dvec2 at = place_px(d);
        const std::uint8_t* p = shot.at(static_cast<int>(at.x), static_cast<int>(at.y));
        const dvec2 seen = lens.project({d.x, -d.y, -d.z}).value();
        EXPECT_NEAR(p[0], seen.x, 3.0);
        EXPECT_NEAR(p[1], 255.0 - seen.y, 3.0);
        EXPECT_GT(
            std::abs(seen.x - Gradient::level(d.x)) + std::abs(seen.y - Gradient::level(-d.y)), 6.0)
            << "another lens would show";
    }
    const dquat aside = glm::angleAxis(glm::radians(50.0), kUp);
    const dvec2 at = place_px({0.0, 0.0, -1.0});
    const Shot beyond = painted(nothing(), behind, aside, aside);
    EXPECT_LE(beyond.at(static_cast<int>(at.x), static_cast<int>(at.y))[2], 1);
}

// FisheyeLens::project is held to OpenCV's in its own test.
TEST_F(SeeThroughTest, AFisheyeIsSeenBesideTheCameraToo) {
    const camera::FisheyeLens lens({.fx_px = 68.0,
                                    .fy_px = 66.0,
                                    .cx_px = 125.0,
                                    .cy_px = 130.0,
                                    .k = {-0.02, 0.004, -0.001, 0.0002}});
    BehindPicture behind = camera_.view();
    behind.lens = lens;
    for (const double turned_deg : {0.0, 40.0, 75.0}) {
        const dquat head = glm::angleAxis(glm::radians(turned_deg), kUp);
        const Shot shot = painted(nothing(), behind, head, head);
        if (turned_deg == 75.0) test::keep(shot, "see_through_fisheye");
        for (const dvec3& now : kDirections) {
            const dvec3 d = head * now;  // in the camera's axes; behind its plane in part
            const dvec2 at = place_px(now), seen = lens.project({d.x, -d.y, -d.z}).value();
            const std::uint8_t* p = shot.at(static_cast<int>(at.x), static_cast<int>(at.y));
            EXPECT_NEAR(p[0], seen.x, 3.0) << turned_deg;
            EXPECT_NEAR(p[1], 255.0 - seen.y, 3.0) << turned_deg;
        }
    }
}

TEST_F(SeeThroughTest, StandsStillInTheWorldWhileTheHeadTurns) {
    const dquat newest = glm::angleAxis(glm::radians(12.0), kUp);
    const dquat rendered = glm::angleAxis(glm::radians(9.0), kUp);
    const Shot shot = painted(nothing(), newest, rendered);
    for (const dvec3& now : kDirections) expect_camera(shot, place_px(now), newest * now);
}

TEST_F(SeeThroughTest, SurfacesHideItHoweverDark) {
    for (const vec3& colour : {vec3(0.0F), vec3(0.5F), vec3(1e-4F)}) {
        const Shot shot = painted(filled(colour));
        const Shot plain = [&] {
            const std::array<dmat3, 2> same{dmat3(1.0), dmat3(1.0)};
            painter_->paint(kPanel, 2, same);
            return test::shot_of_framebuffer(960, 540);
        }();
        const dvec2 at = place_px({0.1, 0.1, -1.0});
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(shot.at(static_cast<int>(at.x), static_cast<int>(at.y))[c],
                        plain.at(static_cast<int>(at.x), static_cast<int>(at.y))[c], 1);
        }
    }
}

TEST_F(SeeThroughTest, AnEdgeIsMixedByTheShareThatMetNothing) {
    Image half = nothing();
    const int edge = half.width_px / 2;
    for (int y = 0; y < half.height_px; ++y) {
        for (int x = 0; x < edge; ++x) {
            half.pixels[static_cast<std::size_t>(y * half.width_px + x)] = vec3(0.0F, 0.0F, 1.0F);
        }
    }
    const Shot shot = painted(half);
    // From surface to camera without a dark rim: blue falls steadily from 255 to 80.
    const TangentFrustum f = map_.frustum(Eye::left);
    const double tangent = -f.left + (f.left + f.right) * edge / half.width_px;
    const dvec2 at = place_px({tangent, 0.0, -1.0});
    int before = 255;
    for (int x = static_cast<int>(at.x) - 6; x <= static_cast<int>(at.x) + 6; ++x) {
        const int blue = shot.at(x, static_cast<int>(at.y))[2];
        EXPECT_LE(blue, before + 1);
        EXPECT_GE(blue, 78);
        before = blue;
    }
    EXPECT_LE(before, 82);
}

TEST_F(SeeThroughTest, IsBlackBeyondTheCamerasEdges) {
    const dquat newest = glm::angleAxis(glm::radians(100.0), kUp);
    const Shot shot = painted(nothing(), newest, newest);
    const dvec2 at = place_px({-0.3, 0.0, -1.0});
    EXPECT_LE(shot.at(static_cast<int>(at.x), static_cast<int>(at.y))[1], 1);
}

}  // namespace
}  // namespace foverig
