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

TEST(FrameErrors, AreNothingBetweenEqualImagesAndOneBetweenBlackAndWhite) {
    const EyeInput eye = eye_looking({0.0F, 0.0F, -1.0F});
    const auto none = errors_of(grey(0.4F), grey(0.4F), eye);
    const auto all = errors_of(grey(0.0F), grey(1.0F), eye);
    for (const std::string& name : error_names()) {
        EXPECT_EQ(none.at(name), 0.0) << name;
        EXPECT_NEAR(all.at(name), 1.0, 0.04) << name;  // FLIP of it is 0.967
    }
}

TEST(FrameErrors, CountMoreWhereTheEyeLooks) {
    Image spot = grey(0.2F);
    for (int y = 30; y < 50; ++y)
        for (int x = 30; x < 50; ++x) spot.at(x, y) = vec3(0.8F);
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
