// The pipelines on our own BVH against the same pipelines on Embree.
#include <gtest/gtest.h>

#include "renderer/scene/library.h"
#include "tests/renderer/small_scenes.h"

namespace foverig {
namespace {

struct Rendered {
    Image image;
    FrameStats stats;
    std::string backend;
};

Rendered render(const std::shared_ptr<const Scene>& scene, const char* pipeline,
                const char* backend, double time_s) {
    RenderSettings settings = settings_of(pipeline);
    settings.backend = backend;
    // In `reprojected` one pixel more or less in a queue gives those after it other samples.
    const bool sampled = settings.pipeline != "reprojected";
    settings.lighting.ao_samples = sampled ? 4 : 0;
    settings.lighting.area_samples = sampled ? 2 : 0;
    const auto renderer = make_renderer(scene, settings);
    const CameraKey& key = scene->camera_path[0];
    FrameInput input = frame_of(view_at(key.position_m, key.target_m, 160, 128));
    Rendered r;
    for (std::uint32_t frame = 0; frame < 3; ++frame) {
        input.frame = frame;
        input.time_s = time_s;
        r.stats = renderer->render(input);
    }
    r.image = renderer->image(0);
    r.backend = renderer->backend_name();
    return r;
}

/// Where the tracers hit different triangles, or the same with t a few ulps apart, a shadow or a
/// sample can turn out differently; nowhere else.
void expect_same_image(const std::string& scene_name, const char* pipeline, double time_s = 0.0) {
    const auto scene = std::make_shared<const Scene>(make_builtin_scene(scene_name, 0.1));
    const Rendered peer = render(scene, pipeline, "embree", time_s);
    const Rendered ours = render(scene, pipeline, "host-bvh", time_s);
    EXPECT_EQ(peer.backend, "embree");
    EXPECT_EQ(ours.backend, "host-bvh");
    EXPECT_EQ(ours.stats.numerics.nan, 0U);
    EXPECT_NEAR(static_cast<double>(ours.stats.rays.primary),
                static_cast<double>(peer.stats.rays.primary),
                1.0e-2 * static_cast<double>(peer.stats.rays.primary));
    ASSERT_EQ(ours.image.pixels.size(), peer.image.pixels.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < ours.image.pixels.size(); ++i) {
        const vec3 apart = glm::abs(ours.image.pixels[i] - peer.image.pixels[i]);
        different += apart.x + apart.y + apart.z > 0.01F ? 1U : 0U;
    }
    EXPECT_LT(different, ours.image.pixels.size() / 200) << scene_name << " " << pipeline;
}

TEST(HostBvh, FullIsThatOfEmbree) {
    expect_same_image("cornell", "full");
    expect_same_image("atrium", "full");
}
TEST(HostBvh, FullIsThatOfEmbreeWhereThingsHaveMoved) {
    expect_same_image("cornell", "full", 2.3);
}
TEST(HostBvh, ReprojectedIsThatOfEmbree) {
    expect_same_image("atrium", "reprojected");
}
TEST(HostBvh, ReferenceIsThatOfEmbree) {
    expect_same_image("cornell", "reference");
}

}  // namespace
}  // namespace foverig
