#include "rig/session/camera_flight.h"

#include <gtest/gtest.h>

namespace foverig {
namespace {

Scene scene_with_path() {
    Scene scene;
    scene.origin_m = {100.0, 0.0, 0.0};
    scene.camera_path_s = 10.0F;
    scene.camera_path = {{vec3(0, 1, 0), vec3(0, 1, -1)},
                         {vec3(1, 1, 0), vec3(2, 1, 0)},
                         {vec3(2, 2, 1), vec3(2, 2, 5)}};
    return scene;
}

dvec3 ahead(const Stand& stand) {
    return stand.world_from_body * dvec3(0, 0, -1);
}

TEST(CameraFlight, GoesThroughItsKeysThereAndBack) {
    const CameraFlight flight({}, scene_with_path());
    EXPECT_NEAR(glm::distance(flight.at(0.0).position_m, dvec3(0, 1, 0)), 0.0, 1e-9);
    EXPECT_NEAR(glm::distance(flight.at(5.0).position_m, dvec3(1, 1, 0)), 0.0, 1e-9);
    EXPECT_NEAR(glm::distance(flight.at(10.0).position_m, dvec3(2, 2, 1)), 0.0, 1e-9);
    EXPECT_NEAR(glm::distance(flight.at(20.0).position_m, dvec3(0, 1, 0)), 0.0, 1e-9);
    EXPECT_NEAR(glm::distance(ahead(flight.at(5.0)), dvec3(1, 0, 0)), 0.0, 1e-9);
}

TEST(CameraFlight, NeverJumps) {
    const CameraFlight flight({}, scene_with_path());
    for (int i = 0; i < 4500; ++i) {
        const Stand a = flight.at(0.01 * i);
        const Stand b = flight.at(0.01 * (i + 1));
        EXPECT_LT(glm::distance(a.position_m, b.position_m), 0.02) << i;
        EXPECT_GT(glm::dot(ahead(a), ahead(b)), 0.999) << i;
        EXPECT_NEAR(glm::determinant(a.world_from_body), 1.0, 1e-12);
    }
}

TEST(CameraFlight, StandsWhereTheScenarioSaysInFileCoordinates) {
    const CameraFlight flight({.path = "still",
                               .position_m = {101.0, 2.0, 3.0},
                               .target_m = {101.0, 2.0, 0.0},
                               .keys_m = {}},
                              scene_with_path());
    EXPECT_NEAR(glm::distance(flight.at(7.0).position_m, dvec3(1, 2, 3)), 0.0, 1e-6);
    EXPECT_NEAR(glm::distance(ahead(flight.at(7.0)), dvec3(0, 0, -1)), 0.0, 1e-6);
}

TEST(CameraFlight, FliesTheScenariosOwnKeys) {
    const CameraFlight flight({.path = "keys",
                               .position_m = {},
                               .target_m = {},
                               .keys_m = {100, 1, 0, 100, 1, -1, 104, 1, 0, 104, 1, -1},
                               .one_way_s = 2.0},
                              scene_with_path());
    EXPECT_NEAR(glm::distance(flight.at(0.0).position_m, dvec3(0, 1, 0)), 0.0, 1e-6);
    EXPECT_NEAR(glm::distance(flight.at(1.0).position_m, dvec3(2, 1, 0)), 0.0, 1e-6);
    EXPECT_NEAR(glm::distance(flight.at(2.0).position_m, dvec3(4, 1, 0)), 0.0, 1e-6);
}

TEST(CameraFlight, LooksStraightDownWithoutLosingItsFrame) {
    const CameraFlight flight({.path = "still",
                               .position_m = {100.0, 5.0, 0.0},
                               .target_m = {100.0, 0.0, 0.0},
                               .keys_m = {}},
                              scene_with_path());
    EXPECT_NEAR(glm::determinant(flight.at(0.0).world_from_body), 1.0, 1e-9);
    EXPECT_NEAR(ahead(flight.at(0.0)).y, -1.0, 1e-6);
}

}  // namespace
}  // namespace foverig
