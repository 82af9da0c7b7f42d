// Whole-frame passes, as the GPU runs them, against the tiles of the `reprojected` pipeline.
#include "renderer/pipelines/frame/reprojected_frame.h"

#include <gtest/gtest.h>

#include "renderer/backends/host_bvh/host_backend.h"
#include "renderer/pipelines/frame/frame_renderer.h"
#include "tests/renderer/pipelines/reprojected_flight.h"

namespace foverig {
namespace {

using FrameTwin = FrameRenderer<host_bvh::HostBackend, ReprojectedFrame>;

constexpr int kTwinWidth = 199;  // tiles are cut off at both edges
constexpr int kTwinHeight = 171;

FrameInput two_eyes(const Scene& scene, int frame) {
    FrameInput input = input_at(scene, frame, false, kTwinWidth, kTwinHeight);
    input.eyes.push_back(input.eyes[0]);
    const vec3 right = input.eyes[0].view.world_from_eye * vec3(0.064F, 0.0F, 0.0F);
    input.eyes[1].view.position_m += right;
    input.eyes[1].gaze = glm::normalize(vec3(-0.2F, 0.1F, -1.0F));
    return input;
}

/// Pixels that are further apart than the rounding of one source compiled twice explains: a half's
/// step, or a sample that falls on the other side of a decision.
double share_apart(const Image& a, const Image& b) {
    std::size_t apart = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const vec3 step = 0x1.0p-8F * a.pixels[i] + 0x1.0p-16F;
        const vec3 d = glm::abs(a.pixels[i] - b.pixels[i]);
        apart += glm::any(glm::greaterThan(d, step)) ? 1U : 0U;
    }
    return static_cast<double>(apart) / static_cast<double>(a.pixels.size());
}

std::size_t different(const Mask& a, const Mask& b) {
    std::size_t n = a.pixels.size() == b.pixels.size() ? 0 : 1;
    for (std::size_t i = 0; n == 0 && i < a.pixels.size(); ++i) n += a.pixels[i] != b.pixels[i];
    return n;
}

/// A flight of both; the last frame's images are compared, the counts of all.
void expect_flight_of_tiles(const char* name, RenderSettings settings, double most_apart) {
    const auto scene = builtin(name);
    settings.backend = "host-bvh";
    const auto tiles = make_renderer(scene, settings);
    FrameTwin frames(scene, settings, {});
    for (int frame = 0; frame < 6; ++frame) {
        const FrameInput input = two_eyes(*scene, frame);
        const FrameStats expected = tiles->render(input);
        const FrameStats stats = frames.render(input);
        EXPECT_NEAR(static_cast<double>(stats.rays.primary),
                    static_cast<double>(expected.rays.primary),
                    1e-3 * static_cast<double>(expected.rays.primary))
            << name << ", frame " << frame;
        EXPECT_EQ(stats.numerics.nan, 0U);
        for (int eye = 0; eye < 2; ++eye) {
            EXPECT_LE(share_apart(tiles->image(eye), frames.image(eye)), most_apart)
                << name << ", frame " << frame << ", eye " << eye;
            if (frame == 0) continue;
            EXPECT_LE(different(tiles->sampling_mask(eye), frames.sampling_mask(eye)), 40U);
            EXPECT_LE(different(tiles->resampling_mask(eye), frames.resampling_mask(eye)), 40U);
        }
    }
}

TEST(ReprojectedFrame, IsTheFlightOfTheTilesUnderAPointLight) {
    expect_flight_of_tiles("atrium", only_point_light(), 1e-3);
    expect_flight_of_tiles("tunnel-geom", only_point_light(), 1e-3);
}

TEST(ReprojectedFrame, IsTheFlightOfTheTilesWithOversampling) {
    RenderSettings settings = only_point_light();
    settings.reprojection.oversampling = true;
    settings.reprojection.footprint_samples = 4;
    expect_flight_of_tiles("atrium", settings, 1e-3);
}

TEST(ReprojectedFrame, IsTheFlightOfTheTilesUnderALamp) {
    RenderSettings settings = settings_of("reprojected");
    settings.lighting.area_samples = 4;
    expect_flight_of_tiles("cornell", settings, 2e-3);
}

/// Occlusion rays go in another order there, so the noise is another: not more of it.
TEST(ReprojectedFrame, OcclusionErrsNoMoreThanByTiles) {
    const auto scene = builtin("atrium");
    RenderSettings settings = all_light();
    settings.backend = "host-bvh";
    RenderSettings true_settings = as_full(settings);
    true_settings.lighting.ao_samples = true_settings.lighting.area_samples = 64;
    const auto tiles = make_renderer(scene, settings);
    FrameTwin frames(scene, settings, {});
    FrameInput input;
    for (int frame = 0; frame < 8; ++frame) {
        input = input_at(*scene, frame, false, kTwinWidth, kTwinHeight);
        tiles->render(input);
        frames.render(input);
    }
    const auto truth = make_renderer(scene, true_settings);
    truth->render(input);
    const double by_tiles = mean_absolute_error(tiles->image(0), truth->image(0));
    const double by_frames = mean_absolute_error(frames.image(0), truth->image(0));
    EXPECT_GT(by_tiles, 1.0e-3) << "there is no noise to compare";
    EXPECT_LE(by_frames, 1.05 * by_tiles);
}

TEST(ReprojectedFrame, PricesEveryEffectThatIsOn) {
    const auto scene = builtin("cornell");
    FrameTwin frames(scene, all_light(), {});
    for (int frame = 0; frame < 2; ++frame) frames.render(two_eyes(*scene, frame));
    for (const PlannedEffect& effect : frames.plan().effects()) {
        if (!effect.on || effect.passes.empty()) continue;
        EXPECT_GT(effect.measured_ms, 0.0) << effect.name;
    }
    EXPECT_GT(frames.backend_bytes(), 0U);
}

}  // namespace
}  // namespace foverig
