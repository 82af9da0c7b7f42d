#include "renderer/pipelines/frame/light_tables.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/renderer/small_scenes.h"

namespace foverig {
namespace {

struct Fixture {
    Fixture(int area_lights, int area_samples, int ao_samples)
        : scene(make(area_lights)), settings(settings_of("full")) {
        settings.lighting.area_samples = area_samples;
        settings.lighting.ao_samples = ao_samples;
        plan = EffectPlan(scene, settings);
        tables = LightTables(memory, plan, scene, settings.lighting);
    }
    static Scene make(int area_lights) {
        SmallScene s;
        s.add_quad(s.add_matte(vec3(0.5F)), {-1, -1, -2}, {2, 0, 0}, {0, 2, 0});
        s.scene().area_lights.resize(static_cast<std::size_t>(area_lights));
        s.scene().ambient = vec3(0.1F);
        return *s.finish();
    }

    Scene scene;
    RenderSettings settings;
    EffectPlan plan;
    EffectMemory memory;
    LightTables tables;
};

TEST(LightTables, AllocateOnlyWhatThePlanHasOn) {
    EXPECT_EQ(Fixture(0, 8, 0).memory.bytes(), 0U);
    EXPECT_EQ(Fixture(2, 8, 0).memory.bytes(), 2U * 2U * 16U * 8U * sizeof(float));
    EXPECT_EQ(Fixture(0, 8, 4).memory.bytes(), 3U * 16U * 4U * sizeof(float));
}

TEST(LightTables, AreCountedUnderTheirOwnLight) {
    const Fixture both(2, 8, 4);
    EXPECT_EQ(both.memory.bytes(Effect::area_light), 2U * 2U * 16U * 8U * sizeof(float));
    EXPECT_EQ(both.memory.bytes(Effect::ambient_occlusion), 3U * 16U * 4U * sizeof(float));
}

TEST(LightTables, EachPatternsAreaPointsAreStratified) {
    Fixture f(1, 16, 0);
    f.tables.update(1, 5);
    const PatternTable t = f.tables.area(0);
    for (int pattern = 0; pattern < kPatterns; ++pattern) {
        std::set<int> cells;
        for (int k = 0; k < 16; ++k)
            cells.insert(static_cast<int>(4.0F * t.get(0, pattern, k)) * 4 +
                         static_cast<int>(4.0F * t.get(1, pattern, k)));
        EXPECT_EQ(cells.size(), 16U);
    }
}

TEST(LightTables, FourSamplesInARowLieInOneQuarterOfTheLampTheSameInEachPattern) {
    for (const int samples : {8, 16}) {
        Fixture f(1, samples, 0);
        f.tables.update(1, 5);
        const PatternTable t = f.tables.area(0);
        for (int first = 0; first < samples; first += 4) {
            std::set<int> quarters;
            for (int pattern = 0; pattern < kPatterns; ++pattern)
                for (int k = first; k < first + 4; ++k)
                    quarters.insert(static_cast<int>(2.0F * t.get(0, pattern, k)) * 2 +
                                    static_cast<int>(2.0F * t.get(1, pattern, k)));
            EXPECT_EQ(quarters.size(), samples == 16 ? 1U : 2U);  // of eight samples: one half
        }
    }
}

TEST(LightTables, OcclusionDirectionsAreUnitAndUp) {
    Fixture f(0, 8, 4);
    f.tables.update(1, 5);
    const PatternTable t = f.tables.occlusion();
    for (int pattern = 0; pattern < kPatterns; ++pattern) {
        for (int k = 0; k < 4; ++k) {
            const vec3 d{t.get(0, pattern, k), t.get(1, pattern, k), t.get(2, pattern, k)};
            EXPECT_NEAR(glm::length(d), 1.0F, 1.0e-6F);
            EXPECT_GE(d.z, 0.0F);
        }
    }
}

TEST(LightTables, AreTheFramesOwnAndTwoLightsDiffer) {
    Fixture f(2, 8, 0);
    const auto first = [&](std::size_t light, std::uint32_t seed, std::uint32_t frame) {
        f.tables.update(seed, frame);
        return f.tables.area(light).get(0, 0, 0);
    };
    const float point = first(0, 1, 5);
    EXPECT_EQ(first(0, 1, 5), point);
    EXPECT_NE(first(0, 1, 6), point);
    EXPECT_NE(first(0, 2, 5), point);
    EXPECT_NE(first(1, 1, 5), point);
}

}  // namespace
}  // namespace foverig
