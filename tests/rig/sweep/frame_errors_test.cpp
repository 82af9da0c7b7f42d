#include "rig/sweep/frame_errors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rig/sweep/records.h"

namespace foverig::sweep {
namespace {

EyeInput eye_looking(const vec3& gaze) {
    EyeInput eye;
    eye.view.width_px = 80;
    eye.view.height_px = 80;
    eye.gaze = gaze;
    return eye;
}

Image grey(float linear) {
    return {80, 80, std::vector<vec3>(80U * 80U, vec3(linear))};
}

constexpr double kRate_hz = 75.0;

/// Of a frame that nothing went before.
std::map<std::string, double> errors_of(const Image& reference, const Image& test,
                                        const EyeInput& eye) {
    return FrameErrors(kRate_hz, true).add(reference, test, eye);
}

TEST(FrameErrors, AreNothingBetweenEqualImagesAndOneBetweenBlackAndWhite) {
    const EyeInput eye = eye_looking({0.0F, 0.0F, -1.0F});
    const auto none = errors_of(grey(0.4F), grey(0.4F), eye);
    const auto all = errors_of(grey(0.0F), grey(1.0F), eye);
    for (const std::string& name : error_names()) EXPECT_EQ(none.at(name), 0.0) << name;
    for (const char* name : {"absolute", "flip", "acuity", "flip_acuity", "fovea", "periphery"})
        EXPECT_NEAR(all.at(name), 1.0, 0.04) << name;  // FLIP of it is 0.967
    EXPECT_EQ(all.at("change"), 0.0) << "nothing went before";
    EXPECT_LT(all.at("flicker"), 0.02)
        << "before it all was as in it; the filter's sum is hardly 0";
    EXPECT_EQ(FrameErrors(kRate_hz, false).add(grey(0.0F), grey(1.0F), eye).count("fvvdp"), 0U);
}

// The reference stands still; the other jumps between two greys, or keeps the brighter.
TEST(FrameErrors, SeeAFlickerThatNoStillShows) {
    const EyeInput eye = eye_looking({0.0F, 0.0F, -1.0F});
    FrameErrors steady(kRate_hz, true);
    FrameErrors jumping(kRate_hz, true);
    std::map<std::string, double> still, flickering;
    for (int i = 0; i < 24; ++i) {
        still = steady.add(grey(0.2F), grey(0.3F), eye);
        flickering = jumping.add(grey(0.2F), grey(i / 8 % 2 == 0 ? 0.3F : 0.133F), eye);
        if (i == 8) {
            EXPECT_NEAR(flickering.at("change"), (148.877 - 102.048) / 255.0, 1e-3)
                << "sRGB codes of 0.3 and 0.133";
            EXPECT_EQ(still.at("change"), 0.0);
        }
    }
    EXPECT_NEAR(still.at("absolute"), flickering.at("absolute"), 0.02) << "codes are as far off";
    EXPECT_LT(still.at("flicker"), 0.02 * still.at("absolute"));
    EXPECT_GT(flickering.at("flicker"), 10.0 * still.at("flicker"));
}

/// A bright square on grey: what is flat has no contrast that FovVideoVDP could see.
Image square(float linear) {
    Image image = grey(0.2F);
    for (int y = 30; y < 50; ++y)
        for (int x = 30; x < 50; ++x) image.at(x, y) = vec3(linear);
    return image;
}

// Of the frames before one matters only that they were seen.
TEST(FrameErrors, AreTheSameWhetherThoseBeforeWereJudgedOrOnlySeen) {
    const EyeInput eye = eye_looking({0.0F, 0.0F, -1.0F});
    FrameErrors judged(kRate_hz, true);
    FrameErrors seen(kRate_hz, true);
    for (const float shown : {0.3F, 0.1F, 0.5F, 0.2F}) {
        judged.add(square(0.4F), square(shown), eye);
        seen.see(square(0.4F), square(shown));
    }
    const auto errors = seen.add(square(0.4F), square(0.45F), eye);
    EXPECT_EQ(errors, judged.add(square(0.4F), square(0.45F), eye));
    const auto alone = errors_of(square(0.4F), square(0.45F), eye);
    for (const char* name : {"change", "flicker", "fvvdp"})
        EXPECT_NE(errors.at(name), alone.at(name)) << name << " looks back";
}

TEST(FrameErrors, CountMoreWhereTheEyeLooks) {
    const Image spot = square(0.8F);
    const auto at_it = errors_of(grey(0.2F), spot, eye_looking({0.0F, 0.0F, -1.0F}));
    const float aside = std::sqrt(0.5F);
    const auto beside_it = errors_of(grey(0.2F), spot, eye_looking({aside, 0.0F, -aside}));
    EXPECT_EQ(at_it.at("absolute"), beside_it.at("absolute"));
    EXPECT_EQ(at_it.at("flip"), beside_it.at("flip"));
    EXPECT_GT(at_it.at("acuity"), 4.0 * beside_it.at("acuity"));
    EXPECT_GT(at_it.at("flip_acuity"), 2.0 * beside_it.at("flip_acuity"));
    EXPECT_EQ(beside_it.at("fovea"), 0.0);
    EXPECT_GT(at_it.at("fovea"), at_it.at("periphery"));
}

TEST(FrameErrors, SurviveWhatIsNotANumber) {
    Image broken = grey(0.2F);
    broken.at(3, 3) = vec3(NAN, INFINITY, 0.0F);
    for (const auto& [name, error] :
         errors_of(grey(0.2F), broken, eye_looking({0.0F, 0.0F, -1.0F})))
        EXPECT_TRUE(std::isfinite(error)) << name;
}

}  // namespace
}  // namespace foverig::sweep
