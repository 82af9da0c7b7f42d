#include "simulators/gaze/calibration_map.h"

#include <gtest/gtest.h>

#include "devices/gaze/calibration_targets.h"
#include "simulators/gaze/user_eye.h"

namespace foverig {
namespace {

using gaze::targets_deg;

/// A turn by 3 degrees, a gain of 1.05 and an offset, as complex numbers do it.
dvec2 similar(const dvec2& v) {
    const double c = 1.05 * std::cos(glm::radians(3.0)), s = 1.05 * std::sin(glm::radians(3.0));
    return {c * v.x - s * v.y + 4.0, s * v.x + c * v.y - 1.0};
}
dvec2 affine(const dvec2& v) {
    return {1.1 * v.x + 0.05 * v.y - 3.0, -0.1 * v.x + 0.9 * v.y + 1.0};
}
dvec2 quadratic(const dvec2& v) {
    const dvec2 u = v / 20.0;
    return affine(v) + dvec2(0.5 * u.y * u.y - 0.3 * u.x * u.y, 0.7 * u.x * u.x);
}
dvec2 cubic(const dvec2& v) {
    const dvec2 u = v / 20.0;
    return quadratic(v) + dvec2(0.4 * u.x * u.x * u.x, -0.2 * u.x * u.y * u.y);
}

/// Worst error within the reach after a calibration whose measurements are `wanted =
/// law(measured)`.
double worst_deg(int points, dvec2 (*law)(const dvec2&)) {
    std::vector<dvec2> measured = targets_deg(points, 16.0), wanted;
    for (const dvec2& m : measured) wanted.push_back(law(m));
    const auto map = CalibrationMap::fit(points, measured, wanted);
    if (!map) return 1e9;
    double worst = 0.0;
    for (double x = -16.0; x <= 16.0; x += 4.0)
        for (double y = -16.0; y <= 16.0; y += 4.0)
            worst = std::max(worst, glm::distance(map->corrected_deg({x, y}), law({x, y})));
    return worst;
}

TEST(CalibrationMap, EachNumberOfPointsMeetsItsLawExactly) {
    EXPECT_LT(worst_deg(3, similar), 1e-12);
    EXPECT_LT(worst_deg(5, affine), 1e-12);
    EXPECT_LT(worst_deg(9, quadratic), 1e-12);
    EXPECT_LT(worst_deg(13, cubic), 1e-11);
}

TEST(CalibrationMap, AndNotTheLawThatNeedsMorePoints) {
    EXPECT_GT(worst_deg(1, similar), 0.5);
    EXPECT_GT(worst_deg(3, affine), 0.5);
    EXPECT_GT(worst_deg(5, quadratic), 0.1);
    EXPECT_GT(worst_deg(9, cubic), 0.05);
}

TEST(CalibrationMap, RefusesPointsThatDoNotDetermineIt) {
    const std::vector<dvec2> line{{-8, 0}, {-4, 0}, {0, 0}, {4, 0}, {8, 0}};
    EXPECT_FALSE(CalibrationMap::fit(5, line, line));
    const std::vector<dvec2> same(3, dvec2(1.0));
    EXPECT_FALSE(CalibrationMap::fit(3, same, same));
    EXPECT_FALSE(CalibrationMap::fit(1, {}, {}));
}

TEST(CalibrationMap, IsItselfAfterStoring) {
    std::vector<dvec2> measured = targets_deg(13, 16.0), wanted;
    for (const dvec2& m : measured) wanted.push_back(cubic(m));
    const auto map = CalibrationMap::fit(13, measured, wanted);
    ASSERT_TRUE(map);
    auto bytes = map->encode();
    EXPECT_EQ(CalibrationMap::decode(bytes), map);
    write_u64(bytes, 24, 0x7FF8000000000000U);
    EXPECT_FALSE(CalibrationMap::decode(bytes)) << "not a number";
    EXPECT_EQ(CalibrationMap().corrected_deg({3.0, -7.0}), dvec2(3.0, -7.0));
}

TEST(UserEye, SeesTheOpticalAxisTemporalAndBelow) {
    dvec2 left(0.0), right(0.0);
    constexpr int kPeople = 400;
    for (std::uint64_t seed = 0; seed < kPeople; ++seed) {
        left += UserEye(Side::left, seed, 1.0).seen_deg({0, 0}) / double{kPeople};
        right += UserEye(Side::right, seed, 1.0).seen_deg({0, 0}) / double{kPeople};
    }
    EXPECT_NEAR(left.x, -5.0, 0.2);
    EXPECT_NEAR(right.x, 5.0, 0.2);
    EXPECT_NEAR(left.y, -1.5, 0.2);
    EXPECT_NEAR(right.y, -1.5, 0.2);
}

TEST(UserEye, IsTheAverageEyeAtStrengthZero) {
    EXPECT_EQ(UserEye(Side::left, 1, 0.0).seen_deg({3.0, 4.0}), dvec2(3.0, 4.0));
}

}  // namespace
}  // namespace foverig
