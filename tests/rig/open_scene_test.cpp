#include "rig/open_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rig/failure.h"

namespace foverig {
namespace {

Scenario small_cornell() {
    Scenario s;
    s.scene = "cornell";
    s.scene_detail = 0.1;
    return s;
}

TEST(OpenScene, AddsTheScenariosLights) {
    Scenario s = small_cornell();
    const auto own = open_scene(s);
    s.lights.points_m = {1, 2, 3, 4, 5, 6};
    s.lights.point_intensity = 7.0;
    s.lights.areas_m = {0, 9, 0, 1, 0, 0, 0, 0, 2};
    const auto lit = open_scene(s);
    ASSERT_EQ(lit->point_lights.size(), own->point_lights.size() + 2);
    ASSERT_EQ(lit->area_lights.size(), own->area_lights.size() + 1);
    EXPECT_EQ(lit->point_lights.back().position_m, vec3(dvec3(4, 5, 6) - lit->origin_m));
    EXPECT_EQ(lit->point_lights.back().intensity, vec3(7.0F));
    EXPECT_EQ(lit->area_lights.back().edge_v_m, vec3(0.0F, 0.0F, 2.0F));
}

TEST(OpenScene, LeavesTheScenesLightsOutWhereAskedTo) {
    Scenario s = small_cornell();
    s.lights.keep = false;
    const auto dark = open_scene(s);
    EXPECT_TRUE(dark->point_lights.empty());
    EXPECT_TRUE(dark->area_lights.empty());
}

TEST(OpenScene, NamesTheNearestBuiltInScene) {
    Scenario s;
    s.scene = "voxel_town";
    try {
        open_scene(s);
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("voxel-town"));
    }
}

}  // namespace
}  // namespace foverig
