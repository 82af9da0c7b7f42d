// An effect's bytes: what its arrays must have at this resolution, and what the whole renderer
// grows by when it is on.
#include <gtest/gtest.h>

#include "renderer/kernels/running_estimate.h"
#include "tests/renderer/small_scenes.h"

namespace foverig {
namespace {

constexpr std::uint64_t kThreads = 2;  // as settings_of has it
constexpr std::uint64_t kQueue = 64 * 64 + 16;

std::shared_ptr<const Scene> room(bool area_light, bool ambient, bool textured = false,
                                  bool moves = false) {
    SmallScene s;
    Material material;
    if (textured) {
        s.scene().textures.push_back({4, 4, 1, 0, true, true, false});
        s.scene().texels.assign(16, 0xFF808080U);
        material.diffuse_texture = 0;
    }
    const std::uint16_t white = s.add_material(material);
    s.add_quad(white, {-3, 0, 3}, {6, 0, 0}, {0, 0, -6});
    s.add_quad(white, {-3, 0, -3}, {6, 0, 0}, {0, 4, 0});
    s.scene().point_lights.push_back({{0, 2, 0}, vec3(3.0F)});
    if (area_light)
        s.scene().area_lights.push_back({{-1, 3, -1}, {2, 0, 0}, {0, 0, 2}, vec3(2.0F)});
    if (ambient) s.scene().ambient = vec3(0.2F);
    if (moves) {
        s.scene().motions.resize(1);
        s.end_part();
        s.scene().parts[0].motion = 0;
    }
    return s.finish();
}

struct Memory {
    std::uint64_t total = 0;
    std::vector<PlannedEffect> plan;

    std::uint64_t of(Effect effect) const {
        return plan.at(static_cast<std::size_t>(effect)).bytes.value();
    }
    std::uint64_t effects() const {
        std::uint64_t sum = 0;
        for (const PlannedEffect& e : plan) sum += e.bytes.value();
        return sum;
    }
    std::uint64_t base() const { return total - effects(); }
};

constexpr int kWidth = 130;
constexpr int kHeight = 70;
constexpr std::uint64_t kPixels = std::uint64_t{kWidth} * kHeight;
constexpr std::uint64_t kTiles = 3 * 2;

Memory memory_of(const std::shared_ptr<const Scene>& scene, const RenderSettings& settings,
                 std::size_t eyes = 1) {
    FrameInput input = frame_of(view_at({0, 1.5F, 2.9F}, {0, 1, -1}, kWidth, kHeight));
    input.eyes.resize(eyes, input.eyes.front());
    const auto renderer = make_renderer(scene, settings);
    for (std::uint32_t f = 0; f < 3; ++f) {
        input.frame = f;
        renderer->render(input);
    }
    return {renderer->backend_bytes(), renderer->plan().effects()};
}

class EffectBytes : public testing::TestWithParam<const char*> {
  protected:
    RenderSettings settings() const {
        RenderSettings s = settings_of(GetParam());
        s.lighting.area_samples = 8;
        s.lighting.ao_samples = 4;
        return s;
    }
};

TEST_P(EffectBytes, AreUnknownBeforeAFrameAndZeroWhileOff) {
    const auto renderer = make_renderer(room(false, false), settings());
    for (const PlannedEffect& e : renderer->plan().effects()) {
        if (e.on)
            EXPECT_FALSE(e.bytes.has_value()) << e.name;
        else
            EXPECT_EQ(e.bytes, 0U) << e.name;
    }
    for (const PlannedEffect& e : memory_of(room(false, false), settings()).plan) {
        ASSERT_TRUE(e.bytes.has_value()) << e.name;
        EXPECT_TRUE(e.on || *e.bytes == 0U) << e.name;
    }
}

TEST_P(EffectBytes, AreWhatTheRendererGrowsByAndTheBaseStays) {
    const Memory bare = memory_of(room(false, false), settings());
    const Memory area = memory_of(room(true, false), settings());
    const Memory both = memory_of(room(true, true), settings());
    EXPECT_GT(area.of(Effect::light_buffer), 0U);
    EXPECT_EQ(area.base(), bare.base());
    EXPECT_EQ(both.base(), bare.base());
    EXPECT_EQ(both.total - area.total, both.of(Effect::ambient_occlusion));
    RenderSettings off = settings();
    off.effects["area_light"] = "off";
    off.effects["ambient_occlusion"] = "off";
    const Memory refused = memory_of(room(true, true), off);
    EXPECT_EQ(refused.total, bare.total);
    EXPECT_EQ(refused.of(Effect::light_buffer), 0U);
}

TEST_P(EffectBytes, OfLightsAreTheirTablesAndQueues) {
    const Memory m = memory_of(room(true, true), settings());
    const std::uint64_t patterns = kThreads * kQueue * 4;
    EXPECT_EQ(m.of(Effect::area_light), 2 * 16 * 8 * sizeof(float) + patterns);
    const std::uint64_t queue = kThreads * (kQueue * (4 + 4) + 64 * 64 * 2);  // slot, pattern, key
    EXPECT_EQ(m.of(Effect::ambient_occlusion), 3 * 16 * 4 * sizeof(float) + queue);
    EXPECT_EQ(m.of(Effect::point_light), 0U);
}

TEST_P(EffectBytes, OfTexturesAreTheirTablesAndGoWithThem) {
    const Memory plain = memory_of(room(false, false), settings());
    const Memory textured = memory_of(room(false, false, true), settings());
    EXPECT_EQ(plain.of(Effect::textures), 0U);
    // 16 texels of 8 bytes, a float for each of 4 triangles, 12 bytes for each of 17 levels
    EXPECT_EQ(textured.of(Effect::textures), 16U * 8U + 4U * 4U + 17U * 12U);
    RenderSettings off = settings();
    off.effects["textures"] = "off";
    EXPECT_EQ(memory_of(room(false, false, true), off).total, plain.total);
}

TEST_P(EffectBytes, OfMovingGeometryAreTheNormalsThatTurnWithIt) {
    const Memory moving = memory_of(room(false, false, false, true), settings());
    EXPECT_EQ(moving.of(Effect::moving_geometry), 8U * 12U);
    RenderSettings off = settings();
    off.effects["moving_geometry"] = "off";
    EXPECT_EQ(memory_of(room(false, false, false, true), off).total,
              memory_of(room(false, false), settings()).total);
}

INSTANTIATE_TEST_SUITE_P(Pipelines, EffectBytes,
                         testing::Values("full", "reprojected", "reference"));

// Queues and surface records of the light buffer are a thread's; images and samples an eye's.
TEST(EffectBytesOf, TheLightBufferFollowFromTheResolution) {
    const std::uint64_t scratch = kThreads * kQueue * 4 * 4;  // four rows of floats
    const Memory full = memory_of(room(true, false), settings_of("full"));
    EXPECT_EQ(full.of(Effect::light_buffer), scratch);
    RenderSettings s = settings_of("reprojected");
    s.reprojection.support_width_px = 30;
    s.reprojection.support_height_px = 20;
    const std::uint64_t images = 2 * (kPixels + 30 * 20) * 8;
    const std::uint64_t samples = 3 * kTiles * 64 * 64 * 8;
    for (const std::size_t eyes : {1U, 2U}) {
        EXPECT_EQ(memory_of(room(true, false), s, eyes).of(Effect::light_buffer),
                  scratch + eyes * (images + samples));
    }
}

TEST(EffectBytesOf, ReprojectionAreWhatThePipelineHasMoreThanFull) {
    for (const bool light : {false, true}) {
        const Memory full = memory_of(room(light, light), settings_of("full"));
        const Memory ours = memory_of(room(light, light), settings_of("reprojected"));
        EXPECT_EQ(full.of(Effect::reprojection), 0U);
        EXPECT_EQ(ours.base(), full.base());
        // At least the last frame's colour and the cache info of two frames.
        EXPECT_GT(ours.of(Effect::reprojection), kPixels * (8 + 2 * sizeof(CacheInfo)));
        EXPECT_EQ(ours.of(Effect::post_process), 0U);
    }
}

}  // namespace
}  // namespace foverig
