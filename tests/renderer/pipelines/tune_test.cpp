// Other settings while frames run: what a renderer of those settings would draw, and the history
// kept.
#include <gtest/gtest.h>

#include "tests/renderer/pipelines/reprojected_flight.h"

namespace foverig {
namespace {

constexpr int kWidth = 96, kHeight = 80;

FrameStats draw(Renderer& renderer, const Scene& scene, int frame) {
    return renderer.render(input_at(scene, frame, false, kWidth, kHeight));
}

RenderSettings other_than(RenderSettings s) {
    s.foveation = {.r0_deg = 6.0, .r1_deg = 14.0, .p_min = 0.3};
    s.lighting.area_samples = 9;
    s.lighting.ao_samples = 5;
    s.reprojection.epsilon_depth = 0.1;
    s.reprojection.t_max = 12;
    s.seed = 77;
    return s;
}

double mean_difference(const Image& a, const Image& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        sum += glm::dot(glm::abs(dvec3(a.pixels[i]) - dvec3(b.pixels[i])), dvec3(1.0 / 3.0));
    return sum / static_cast<double>(a.pixels.size());
}

class Tune : public testing::TestWithParam<const char*> {
  protected:
    RenderSettings settings() const {
        RenderSettings s = all_light();
        s.pipeline = GetParam();
        return s;
    }
    std::shared_ptr<const Scene> scene = builtin("atrium");
};

TEST_P(Tune, DrawsWhatARendererOfThoseSettingsDraws) {
    const auto tuned = make_renderer(scene, settings());
    const auto fresh = make_renderer(scene, other_than(settings()));
    ASSERT_TRUE(tuned->tune(other_than(settings())));
    for (int frame = 0; frame < 3; ++frame) {
        const FrameStats a = draw(*tuned, *scene, frame);
        const FrameStats b = draw(*fresh, *scene, frame);
        EXPECT_EQ(a.rays.shadow, b.rays.shadow);
        EXPECT_EQ(a.rays.ao, b.rays.ao);
        ASSERT_EQ(tuned->image(0).pixels, fresh->image(0).pixels) << "frame " << frame;
    }
    EXPECT_EQ(tuned->plan().effects()[static_cast<std::size_t>(Effect::area_light)].because,
              fresh->plan().effects()[static_cast<std::size_t>(Effect::area_light)].because);
    EXPECT_EQ(tuned->backend_bytes(), fresh->backend_bytes());
}

TEST_P(Tune, RefusesWhatNeedsAnotherRendererAndStaysAsItWas) {
    const auto tuned = make_renderer(scene, settings());
    const auto same = make_renderer(scene, settings());
    RenderSettings pipeline = settings(), support = settings(), effect = settings(),
                   tracer = settings(), jittered = settings();
    pipeline.pipeline = "reference";
    support.reprojection.support_width_px = 20;
    effect.lighting.area_samples = 0;
    tracer.robust_tracing = !tracer.robust_tracing;
    jittered.reprojection.oversampling = true;
    for (const RenderSettings& wanted : {pipeline, support, effect, tracer, jittered}) {
        EXPECT_FALSE(tuned->tune(wanted));
    }
    draw(*tuned, *scene, 0);
    draw(*same, *scene, 0);
    EXPECT_EQ(tuned->image(0).pixels, same->image(0).pixels);
}

INSTANTIATE_TEST_SUITE_P(Pipelines, Tune, testing::Values("full", "reprojected"));

TEST(TuneReprojected, KeepsTheHistory) {
    const auto scene = builtin("atrium");
    RenderSettings every = only_point_light(), few = only_point_light();
    every.foveation.p_min = 1.0;
    few.foveation = {.r0_deg = 0.5, .r1_deg = 1.0, .p_min = 0.01};
    const auto tuned = make_renderer(scene, every);
    const auto sparse = make_renderer(scene, few);
    const auto full = make_renderer(scene, as_full(few));
    const auto all = tuned->render(input_at(*scene, 0));
    EXPECT_EQ(all.sampled_pixels, all.all_pixels);
    sparse->render(input_at(*scene, 0));
    ASSERT_TRUE(tuned->tune(few));
    const auto changed = tuned->render(input_at(*scene, 1));
    sparse->render(input_at(*scene, 1));
    full->render(input_at(*scene, 1));
    EXPECT_LT(changed.sampled_pixels, all.all_pixels / 2);
    const double kept = mean_difference(tuned->image(0), full->image(0));
    EXPECT_LT(kept, 0.5 * mean_difference(sparse->image(0), full->image(0)));
}

}  // namespace
}  // namespace foverig
