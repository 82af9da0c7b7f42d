#include "rig/sweep/flight.h"

#include <gtest/gtest.h>

#include "renderer/scene/library.h"

namespace foverig::sweep {
namespace {

Scenario small_scenario() {
    Scenario scenario;
    scenario.scene = "cornell";
    scenario.frames = 6;
    scenario.settle_s = 0.05;
    scenario.display.eye_width_px = 64;
    scenario.display.eye_height_px = 64;
    return scenario;
}

std::string digest_with(void (*change)(Scenario&)) {
    Scenario scenario = small_scenario();
    change(scenario);
    return digest_of(fly(scenario, make_builtin_scene("cornell", 0.2)));
}

TEST(Flight, IsOneFrameAVsyncOfAMovingHead) {
    const auto flight = fly(small_scenario(), make_builtin_scene("cornell", 0.2));
    ASSERT_EQ(flight.size(), 6U);
    for (std::size_t i = 1; i < flight.size(); ++i) {
        EXPECT_NEAR(flight[i].input.time_s - flight[i - 1].input.time_s, 1.0 / 75.0, 1e-6);
        EXPECT_EQ(flight[i].input.eyes.size(), 2U);
        EXPECT_NE(flight[i].input.eyes[0].view.world_from_eye,
                  flight[i - 1].input.eyes[0].view.world_from_eye);
    }
}

TEST(Flight, DependsOnWhatThereIsToSeeAndNotOnHowItIsRendered) {
    const std::string base = digest_with([](Scenario&) {});
    EXPECT_EQ(digest_with([](Scenario& s) { s.render.foveation.p_min = 0.9; }), base);
    EXPECT_EQ(digest_with([](Scenario& s) { s.render.pipeline = "full"; }), base);
    EXPECT_EQ(digest_with([](Scenario& s) { s.cost = "fixed:200"; }), base);
    EXPECT_NE(digest_with([](Scenario& s) { s.render.seed = 2; }), base) << "the motion's seed";
    EXPECT_NE(digest_with([](Scenario& s) { s.display.eye_width_px = 65; }), base);
    EXPECT_NE(digest_with([](Scenario& s) { s.motion.head = "still"; }), base);
    EXPECT_EQ(digest_with([](Scenario& s) { s.motion.gaze = "still"; }), base)
        << "a reference traces every pixel";
}

TEST(SceneDigest, KnowsEveryArray) {
    const Scene scene = make_builtin_scene("atrium", 0.1);
    const std::string base = digest_of(scene);
    EXPECT_EQ(digest_of(make_builtin_scene("atrium", 0.1)), base);
    const auto changed = [&](auto change) {
        Scene other = scene;
        change(other);
        return digest_of(other) != base;
    };
    EXPECT_TRUE(changed([](Scene& s) { s.positions_m[7].y += 1e-6F; }));
    EXPECT_TRUE(changed([](Scene& s) { s.triangle_materials.back() ^= 1U; }));
    EXPECT_TRUE(changed([](Scene& s) { s.materials[1].diffuse.x += 0.01F; }));
    EXPECT_TRUE(changed([](Scene& s) { s.texels.back() ^= 1U; }));
    EXPECT_TRUE(changed([](Scene& s) { s.textures[0].repeat_v = !s.textures[0].repeat_v; }));
    EXPECT_TRUE(changed([](Scene& s) { s.point_lights[0].intensity.x += 1.0F; }));
    EXPECT_TRUE(changed([](Scene& s) { s.ambient.z += 0.1F; }));
}

}  // namespace
}  // namespace foverig::sweep
