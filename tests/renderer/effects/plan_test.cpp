#include "renderer/effects/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/renderer/small_scenes.h"

namespace foverig {
namespace {

using testing::HasSubstr;

/// A scene that calls for nothing.
Scene bare_scene() {
    SmallScene s;
    s.add_quad(s.add_matte(vec3(0.5F)), {-1, -1, -2}, {2, 0, 0}, {0, 2, 0});
    return *s.finish();
}

const PlannedEffect& effect(const EffectPlan& plan, Effect e) {
    return plan.effects()[static_cast<std::size_t>(e)];
}

EffectPlan plan_of(const Scene& scene, const RenderSettings& settings = settings_of("full")) {
    return {scene, settings};
}

TEST(EffectPlan, ABareSceneCallsForNothingAndEachLineSaysWhy) {
    const EffectPlan plan = plan_of(bare_scene());
    ASSERT_EQ(plan.effects().size(), effect_names().size());
    for (const PlannedEffect& e : plan.effects()) {
        EXPECT_FALSE(e.on) << e.name;
        EXPECT_TRUE(e.passes.empty()) << e.name;
        EXPECT_EQ(e.bytes, 0U) << e.name;
        EXPECT_FALSE(e.because.empty()) << e.name;
    }
}

TEST(EffectPlan, APointLightNeedsOneInTheSceneAndTheSetting) {
    Scene scene = bare_scene();
    EXPECT_THAT(effect(plan_of(scene), Effect::point_light).because, HasSubstr("no point light"));
    scene.point_lights.resize(2);
    const EffectPlan plan = plan_of(scene);
    EXPECT_TRUE(plan.on(Effect::point_light));
    EXPECT_THAT(effect(plan, Effect::point_light).because, HasSubstr("2 point lights"));
    EXPECT_THAT(effect(plan, Effect::point_light).passes, testing::Contains("shadow_point"));
    EXPECT_FALSE(plan.on(Effect::light_buffer));
    RenderSettings s = settings_of("full");
    s.lighting.point_lights = false;
    EXPECT_FALSE(plan_of(scene, s).on(Effect::point_light));
    EXPECT_THAT(effect(plan_of(scene, s), Effect::point_light).because,
                HasSubstr("lighting.point_lights"));
}

TEST(EffectPlan, AnAreaLightNeedsOneInTheSceneSamplesAndTheSetting) {
    Scene scene = bare_scene();
    EXPECT_FALSE(plan_of(scene).on(Effect::area_light));
    scene.area_lights.resize(1);
    EXPECT_TRUE(plan_of(scene).on(Effect::area_light));
    EXPECT_TRUE(plan_of(scene).on(Effect::light_buffer));
    RenderSettings s = settings_of("full");
    s.lighting.area_samples = 0;
    EXPECT_FALSE(plan_of(scene, s).on(Effect::area_light));
    EXPECT_THAT(effect(plan_of(scene, s), Effect::area_light).because,
                HasSubstr("lighting.area_samples"));
    EXPECT_FALSE(plan_of(scene, s).on(Effect::light_buffer));
    s.lighting.area_samples = 8;
    s.lighting.area_lights = false;
    EXPECT_FALSE(plan_of(scene, s).on(Effect::area_light));
}

TEST(EffectPlan, OcclusionNeedsSamplesAndAmbientLightToOcclude) {
    Scene scene = bare_scene();
    RenderSettings s = settings_of("full");
    s.lighting.ao_samples = 4;
    EXPECT_FALSE(plan_of(scene, s).on(Effect::ambient_occlusion));
    EXPECT_THAT(effect(plan_of(scene, s), Effect::ambient_occlusion).because,
                HasSubstr("no ambient light"));
    scene.ambient = vec3(0.0F, 0.1F, 0.0F);
    EXPECT_TRUE(plan_of(scene, s).on(Effect::ambient_occlusion));
    EXPECT_TRUE(plan_of(scene, s).on(Effect::light_buffer));
    s.lighting.ao_samples = 0;
    EXPECT_FALSE(plan_of(scene, s).on(Effect::ambient_occlusion));
}

TEST(EffectPlan, TexturesNeedAMaterialThatUsesOne) {
    SmallScene s;
    s.scene().textures.push_back({1, 1, 1, 0});
    s.scene().texels.push_back(0xFFFFFFFFU);
    const std::uint16_t matte = s.add_matte(vec3(0.5F));
    s.add_quad(matte, {-1, -1, -2}, {2, 0, 0}, {0, 2, 0});
    Scene scene = *s.finish();
    EXPECT_FALSE(plan_of(scene).on(Effect::textures));
    scene.materials[0].diffuse_texture = 0;
    EXPECT_TRUE(plan_of(scene).on(Effect::textures));
    EXPECT_THAT(effect(plan_of(scene), Effect::textures).because, HasSubstr("1 of 1 materials"));
}

TEST(EffectPlan, MasksAndMotionAreCalledForByParts) {
    Scene scene = bare_scene();
    scene.parts[0].alpha_masked = true;
    EXPECT_TRUE(plan_of(scene).on(Effect::alpha_mask));
    EXPECT_THAT(effect(plan_of(scene), Effect::alpha_mask).because, HasSubstr("2 triangles"));
    scene.motions.resize(1);
    EXPECT_FALSE(plan_of(scene).on(Effect::moving_geometry));
    scene.parts[0].motion = 0;
    EXPECT_TRUE(plan_of(scene).on(Effect::moving_geometry));
}

TEST(EffectPlan, HistoryBelongsToTheReprojectedPipelineAndNoiseCallsForThePostProcess) {
    Scene scene = bare_scene();
    EXPECT_FALSE(plan_of(scene, settings_of("full")).on(Effect::reprojection));
    EXPECT_TRUE(plan_of(scene, settings_of("reprojected")).on(Effect::reprojection));
    EXPECT_FALSE(plan_of(scene, settings_of("reprojected")).on(Effect::post_process));
    scene.area_lights.resize(1);
    EXPECT_TRUE(plan_of(scene, settings_of("reprojected")).on(Effect::post_process));
    EXPECT_FALSE(plan_of(scene, settings_of("full")).on(Effect::post_process));
    RenderSettings s = settings_of("reprojected");
    s.reprojection.oversampling = true;
    EXPECT_TRUE(plan_of(scene, s).on(Effect::oversampling));
}

TEST(EffectPlan, APersonMayTurnAnEffectOffAndItSaysSo) {
    Scene scene = bare_scene();
    scene.area_lights.resize(1);
    scene.point_lights.resize(1);
    RenderSettings s = settings_of("reprojected");
    s.effects["area_light"] = "off";
    s.effects["point_light"] = "auto";
    const EffectPlan plan = plan_of(scene, s);
    EXPECT_FALSE(plan.on(Effect::area_light));
    EXPECT_THAT(effect(plan, Effect::area_light).because, HasSubstr("effects.area_light is off"));
    EXPECT_TRUE(effect(plan, Effect::area_light).passes.empty());
    EXPECT_TRUE(plan.on(Effect::point_light));
    EXPECT_FALSE(plan.on(Effect::light_buffer)) << "what rests on it goes with it";
    EXPECT_FALSE(plan.on(Effect::post_process));
}

TEST(EffectPlan, UnknownNamesAndForceAreRefusedByName) {
    const Scene scene = bare_scene();
    RenderSettings s = settings_of("full");
    s.effects["caustics"] = "off";
    try {
        plan_of(scene, s);
        FAIL() << "an unknown effect was taken";
    } catch (const std::invalid_argument& e) {
        EXPECT_THAT(e.what(), HasSubstr("caustics"));
        EXPECT_THAT(e.what(), HasSubstr("area_light"));
    }
    s.effects.clear();
    s.effects["area_light"] = "force";
    try {
        plan_of(scene, s);
        FAIL() << "force was taken";
    } catch (const std::invalid_argument& e) {
        EXPECT_THAT(e.what(), HasSubstr("force"));
        EXPECT_THAT(e.what(), HasSubstr("\"off\""));
    }
}

TEST(EffectPlan, MeasuredCostIsTheMeanOfItsPasses) {
    Scene scene = bare_scene();
    scene.point_lights.resize(1);
    EffectPlan plan = plan_of(scene);
    EXPECT_LT(plan[Effect::point_light].measured_ms, 0.0);
    plan.record_frame({{"shadow_point", 2.0}, {"trace_primary", 9.0}}, 1);
    plan.record_frame({{"shadow_point", 4.0}, {"trace_primary", 9.0}}, 2);
    EXPECT_DOUBLE_EQ(plan[Effect::point_light].measured_ms, 3.0);
    EXPECT_LT(plan[Effect::area_light].measured_ms, 0.0) << "what is off has no cost";
}

}  // namespace
}  // namespace foverig
