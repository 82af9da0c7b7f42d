#include "metrics/eccentricity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foverig::metrics {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

/// DK2 at density 1 (tangents of DEVICES.md 2.2), looking straight ahead.
EyeInput dk2() {
    EyeInput eye;
    eye.view = {1182, 1464, 1.0586F, 1.092425F, 1.331603F, 1.331603F, {}, mat3(1.0F)};
    return eye;
}

TEST(GazedView, HasAboutTenPixelsPerDegreeInTheMiddleOfADk2) {
    const GazedView view = gazed_view(dk2());
    EXPECT_NEAR(view.focal_x_px / kDegrees, 9.59, 0.01);
    EXPECT_NEAR(view.gaze_x_px, view.centre_x_px, 1e-9);
    EXPECT_NEAR(view.gaze_y_px, 732.0, 1e-6);
}

TEST(GazedView, PutsAGazeUpAndRightUpAndRight) {
    EyeInput eye = dk2();
    eye.gaze = glm::normalize(vec3(0.5F, 0.25F, -1.0F));
    const GazedView view = gazed_view(eye);
    EXPECT_NEAR(view.gaze_x_px, view.centre_x_px + 0.5 * view.focal_x_px, 1e-3);
    EXPECT_NEAR(view.gaze_y_px, view.centre_y_px - 0.25 * view.focal_y_px, 1e-3);
}

TEST(PoolByGaze, CountsAFoveaAsLargeAsItsSolidAngle) {
    // Straight ahead the disc has a radius of focal * tan(10 deg).
    const double ppd = 9.59;
    const GazedView view = gazed_screen(800, 600, ppd, 400.0, 300.0);
    const GazedError error = pool_by_gaze(Plane(800, 600), view, 10.0);
    const double radius_px = ppd * kDegrees * std::tan(10.0 / kDegrees);
    const double area_px = std::numbers::pi * radius_px * radius_px;
    EXPECT_NEAR(static_cast<double>(error.fovea_pixels), area_px, 0.005 * area_px);
}

TEST(PoolByGaze, OfAConstantErrorIsThatErrorEverywhere) {
    Plane errors(320, 200);
    std::fill(errors.values.begin(), errors.values.end(), 0.25F);
    const GazedError e = pool_by_gaze(errors, gazed_screen(320, 200, 5.0, 10.0, 190.0), 10.0);
    EXPECT_NEAR(e.fovea, 0.25, 1e-12);
    EXPECT_NEAR(e.periphery, 0.25, 1e-12);
    EXPECT_NEAR(e.acuity, 0.25, 1e-12);
}

TEST(PoolByGaze, SplitsAnErrorThatIsOnlyInTheFovea) {
    Plane errors(400, 400);
    errors.row(200)[200] = 1.0F;
    const GazedView at = gazed_screen(400, 400, 9.6, 200.5, 200.5);
    const GazedView off = gazed_screen(400, 400, 9.6, 390.0, 200.5);
    const GazedError seen = pool_by_gaze(errors, at, 5.0);
    EXPECT_NEAR(seen.fovea, 1.0 / static_cast<double>(seen.fovea_pixels), 1e-12);
    EXPECT_EQ(seen.periphery, 0.0);
    EXPECT_EQ(pool_by_gaze(errors, off, 5.0).fovea, 0.0);
    EXPECT_GT(seen.acuity, 10.0 * pool_by_gaze(errors, off, 5.0).acuity);
}

TEST(PoolByGaze, WeighsByAcuityAsTheIntegralSays) {
    // Error 1 within 8 degrees, 0 beyond, a round field of 20 degrees: the weight of a ring at e is
    // 2 pi sin(e) / (1/48 + 0.022 e)^2.
    const GazedView view = gazed_screen(1000, 1000, 20.0, 500.0, 500.0);
    const double field_px = view.focal_x_px * std::tan(20.0 / kDegrees);
    Plane inner(1000, 1000), field(1000, 1000);
    for (int y = 0; y < 1000; ++y)
        for (int x = 0; x < 1000; ++x) {
            const double r_px = std::hypot(x + 0.5 - 500.0, y + 0.5 - 500.0);
            inner.row(y)[x] = r_px < view.focal_x_px * std::tan(8.0 / kDegrees) ? 1.0F : 0.0F;
            field.row(y)[x] = r_px < field_px ? 1.0F : 0.0F;
        }
    const auto ring_sum = [](double until_deg) {
        double sum = 0.0;
        for (double e = 0.0005; e < until_deg; e += 0.001)
            sum += std::sin(e / kDegrees) / std::pow(1.0 / 48.0 + 0.022 * e, 2);
        return sum;
    };
    EXPECT_NEAR(pool_by_gaze(inner, view, 5.0).acuity / pool_by_gaze(field, view, 5.0).acuity,
                ring_sum(8.0) / ring_sum(20.0), 0.002);
}

}  // namespace
}  // namespace foverig::metrics
