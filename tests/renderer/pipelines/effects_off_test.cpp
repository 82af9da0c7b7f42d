// An effect that is off launches nothing, allocates nothing and changes no bit.
#include <gtest/gtest.h>

#include <set>

#include "renderer/scene/library.h"
#include "tests/renderer/small_scenes.h"

namespace foverig {
namespace {

std::shared_ptr<const Scene> room(bool area_light, bool ambient) {
    SmallScene s;
    const std::uint16_t white = s.add_matte(vec3(0.7F));
    s.add_quad(white, {-3, 0, 3}, {6, 0, 0}, {0, 0, -6});
    s.add_quad(white, {-3, 0, -3}, {6, 0, 0}, {0, 4, 0});
    s.scene().point_lights.push_back({{0, 2, 0}, vec3(3.0F)});
    if (area_light)
        s.scene().area_lights.push_back({{-1, 3, -1}, {2, 0, 0}, {0, 0, 2}, vec3(2.0F)});
    if (ambient) s.scene().ambient = vec3(0.2F);
    return s.finish();
}

const EyeView kView = view_at({0, 1.5F, 2.9F}, {0, 1, -1}, 130, 70);

struct Outcome {
    std::set<std::string> passes;
    std::uint64_t bytes = 0;
    RayCounts rays;
    Image image;
};

Outcome run(const std::shared_ptr<const Scene>& scene, const RenderSettings& settings,
            int frames = 3) {
    const auto renderer = make_renderer(scene, settings);
    Outcome r;
    for (int f = 0; f < frames; ++f) {
        const FrameStats stats = renderer->render(frame_of(kView, static_cast<std::uint32_t>(f)));
        for (const PassTime& p : stats.passes) r.passes.insert(p.name);
        r.rays = stats.rays;
    }
    r.bytes = renderer->backend_bytes();
    r.image = renderer->image(0);
    return r;
}

const std::set<std::string> kPlainPasses{
    "trace_primary", "give_slots",    "shade_surface", "compose",        "select_pixels",
    "queue_pixels",  "store_samples", "show_mean",     "estimate_error", "gather_misses",
    "leave_vertex",  "trace_bounce",  "begin_paths",   "accumulate"};

class EffectsOff : public testing::TestWithParam<const char*> {};

TEST_P(EffectsOff, LaunchNothing) {
    RenderSettings settings = settings_of(GetParam());
    const Outcome bare = run(room(false, false), settings);
    for (const char* name : {"shadow_area", "ambient_occlusion", "post_process", "move_geometry"})
        EXPECT_EQ(bare.passes.count(name), 0U) << name;
    EXPECT_EQ(bare.passes.count("shadow_point"), 1U);
    EXPECT_EQ(bare.rays.ao, 0U);
    settings.lighting.ao_samples = 2;
    const Outcome rich = run(room(true, true), settings);
    for (const char* name : {"shadow_area", "ambient_occlusion", "shadow_point"})
        EXPECT_EQ(rich.passes.count(name), 1U) << name;
    EXPECT_GT(rich.rays.ao, 0U);
    settings.effects["point_light"] = "off";
    EXPECT_EQ(run(room(true, true), settings).passes.count("shadow_point"), 0U);
}

TEST_P(EffectsOff, EveryPassOfThePlanIsLaunchedAndNoneThatIsOff) {
    RenderSettings settings = settings_of(GetParam());
    settings.lighting.ao_samples = 2;
    for (const bool rich : {false, true}) {
        const auto scene = room(rich, rich);
        const auto renderer = make_renderer(scene, settings);
        std::set<std::string> launched;
        for (std::uint32_t f = 0; f < 3; ++f)
            for (const PassTime& p : renderer->render(frame_of(kView, f)).passes)
                launched.insert(p.name);
        for (const PlannedEffect& e : renderer->plan().effects()) {
            for (const std::string& pass : e.passes)
                EXPECT_EQ(launched.count(pass), 1U) << e.name << ' ' << pass;
            EXPECT_EQ(e.measured_ms >= 0.0, !e.passes.empty()) << e.name;
            for (const std::string& pass : e.passes) launched.erase(pass);
        }
        // What is left belongs to the pipeline, whatever the scene calls for.
        for (const std::string& pass : launched) EXPECT_EQ(kPlainPasses.count(pass), 1U) << pass;
    }
}

TEST_P(EffectsOff, AnyOneOffLeavesTheRestWhole) {
    for (const std::string& effect : effect_names()) {
        if (!follows_from(effect).empty()) continue;
        RenderSettings settings = settings_of(GetParam());
        settings.lighting.ao_samples = 2;
        settings.reprojection.oversampling = true;
        settings.effects[effect] = "off";
        const Outcome outcome = run(room(true, true), settings);
        vec3 sum(0.0F);
        for (const vec3& p : outcome.image.pixels) sum += p;
        EXPECT_TRUE(std::isfinite(sum.x + sum.y + sum.z)) << effect;
        EXPECT_GT(sum.x, 0.0F) << effect;
    }
}

TEST_P(EffectsOff, WhatFollowsFromOthersCannotBeTurnedOffAlone) {
    for (const char* effect : {"light_buffer", "reprojection", "nonsense"}) {
        RenderSettings settings = settings_of(GetParam());
        settings.effects[effect] = "off";
        EXPECT_THROW(make_renderer(room(true, true), settings), std::invalid_argument) << effect;
    }
}

TEST_P(EffectsOff, AllocateNothing) {
    const RenderSettings plain = settings_of(GetParam());
    RenderSettings asks = plain;
    asks.lighting.area_samples = 64;
    asks.lighting.ao_samples = 64;
    const std::uint64_t bare = run(room(false, false), plain).bytes;
    EXPECT_EQ(run(room(false, false), asks).bytes, bare);
    EXPECT_GT(run(room(true, false), asks).bytes, bare);
    EXPECT_GT(run(room(false, true), asks).bytes, bare);
    RenderSettings off = asks;
    off.effects["area_light"] = "off";
    off.effects["ambient_occlusion"] = "off";
    EXPECT_EQ(run(room(true, true), off).bytes, bare);
}

TEST_P(EffectsOff, ChangeNoBit) {
    RenderSettings settings = settings_of(GetParam());
    const Outcome none = run(room(false, true), settings);
    settings.lighting.area_samples = 64;
    EXPECT_TRUE(run(room(false, true), settings).image.pixels == none.image.pixels);
    settings.effects["alpha_mask"] = "off";
    settings.effects["textures"] = "off";
    settings.effects["area_light"] = "off";
    EXPECT_TRUE(run(room(true, true), settings).image.pixels == none.image.pixels);
}

TEST_P(EffectsOff, AnAlphaTestOfSolidTexelsChangesNoBit) {
    SmallScene s;
    s.scene().textures.push_back({2, 2, 1, 0, true, true, false});
    s.scene().texels = {0xFF0000FFU, 0xFF00FF00U, 0xFFFF0000U, 0xFFFFFFFFU};
    Material m;
    m.diffuse_texture = 0;
    m.alpha_cutoff = 0.5F;
    s.add_quad(s.add_material(m), {-3, 0, 3}, {6, 0, 0}, {0, 0, -6});
    s.scene().point_lights.push_back({{0, 2, 0}, vec3(3.0F)});
    s.end_part(true);
    const auto scene = s.finish();
    const Outcome tested = run(scene, settings_of(GetParam()));
    RenderSettings settings = settings_of(GetParam());
    settings.effects["alpha_mask"] = "off";
    EXPECT_TRUE(run(scene, settings).image.pixels == tested.image.pixels);
}

INSTANTIATE_TEST_SUITE_P(Pipelines, EffectsOff,
                         testing::Values("full", "reprojected", "reference"));

TEST(Full, ThreadsAndRunsDoNotChangeABit) {
    const auto scene = std::make_shared<const Scene>(make_builtin_scene("cornell", 0.25));
    RenderSettings settings = settings_of("full");
    settings.lighting.ao_samples = 2;
    settings.threads = 1;
    const Outcome one = run(scene, settings, 2);
    settings.threads = 3;
    const Outcome three = run(scene, settings, 2);
    EXPECT_TRUE(one.image.pixels == three.image.pixels);
    EXPECT_EQ(one.rays.total(), three.rays.total());
}

TEST(MakeRenderer, UnknownNamesAreRefusedWithTheKnownOnes) {
    const auto scene = room(false, false);
    RenderSettings settings = settings_of("raster");
    try {
        make_renderer(scene, settings);
        FAIL();
    } catch (const std::invalid_argument& e) {
        for (const std::string& name : pipeline_names())
            EXPECT_NE(std::string(e.what()).find(name), std::string::npos);
    }
    settings = settings_of("full");
    settings.backend = "abacus";
    EXPECT_THROW(make_renderer(scene, settings), std::invalid_argument);
}

TEST(MakeRenderer, MakesEveryPipelineItNames) {
    for (const std::string& name : pipeline_names()) {
        const auto renderer = make_renderer(room(true, true), settings_of(name.c_str()));
        renderer->render(frame_of(kView));
        EXPECT_EQ(renderer->image(0).pixels.size(), 130U * 70U) << name;
        EXPECT_EQ(renderer->backend_name(), "embree");
    }
}

}  // namespace
}  // namespace foverig
