#include "rig/live/cursor_gaze.h"

#include <gtest/gtest.h>

#include "rig/live/gaze_ring.h"
#include "rig/session/angles.h"
#include "simulators/gaze/tracker_geometry.h"

namespace foverig {
namespace {

TEST(CursorGaze, TheEyeUnderTheCursorLooksThroughTheLensAtIt) {
    const EyeMap map(true);
    for (const Eye eye : {Eye::left, Eye::right}) {
        const Side side = eye == Eye::left ? Side::left : Side::right;
        for (const dvec2& ndc : {dvec2(0.0, 0.0), dvec2(0.5, -0.3), dvec2(-0.6, 0.6)}) {
            const dvec3 seen = eye_direction(side, looking_at({eye, ndc}, map));
            const dvec2 back = map.ndc(eye, dvec2(seen.x, seen.y) / -seen.z);
            EXPECT_NEAR(glm::distance(back, ndc), 0.0, 1e-9);
        }
    }
}

TEST(CursorGaze, TheOtherEyeMeetsItAtTheMappingDistance) {
    const EyeMap map(true);
    const motion::EyeState state = looking_at({Eye::left, {0.2, 0.1}}, map);
    const dvec3 left = eye_direction(Side::left, state), right = eye_direction(Side::right, state);
    // 64 mm seen from 1.5 m: 2.4 degrees.
    EXPECT_NEAR(angle_deg(left, right), 2.4, 0.15);
    EXPECT_LT(right.x, left.x) << "they converge";
}

// DEVICES.md 2.2: 9.593 px a degree at the centre, where the lens is straight; NDC 1 is 480 px.
TEST(CursorGaze, AFewPixelsAtTheCentreAreTheirAngle) {
    const EyeMap map(true);
    const dvec2 centre = map.ndc(Eye::left, dvec2(0.0));
    const auto direction_at = [&](double px) {
        const EyePlace place{Eye::left, centre + dvec2(px / 480.0, 0.0)};
        return eye_direction(Side::left, looking_at(place, map));
    };
    EXPECT_NEAR(angle_deg(direction_at(-5.0), direction_at(5.0)), 10.0 / 9.593, 0.002);
}

TEST(GazeRing, IsAConeAroundTheGaze) {
    const EyeMap map(true);
    const dvec3 gaze = glm::normalize(dvec3(0.2, -0.1, -1.0));
    const auto ring = gaze_ring(Eye::right, gaze, 10.0, map);
    ASSERT_GT(ring.size(), 60U);
    EXPECT_NEAR(glm::distance(ring.front(), ring.back()), 0.0, 1e-9) << "closed";
    for (const dvec2& ndc : ring) {
        const dvec3 ray(map.tangent(Eye::right, ndc), -1.0);
        EXPECT_NEAR(angle_deg(gaze, glm::normalize(ray)), 10.0, 1e-6);
    }
}

TEST(GazeRing, LeavesOutWhatNoLensShows) {
    const dvec3 aside = glm::normalize(dvec3(1.0, 0.0, -0.5));
    for (const dvec2& ndc : gaze_ring(Eye::left, aside, 60.0, EyeMap(true)))
        EXPECT_TRUE(std::isfinite(ndc.x) && std::isfinite(ndc.y));
}

}  // namespace
}  // namespace foverig
