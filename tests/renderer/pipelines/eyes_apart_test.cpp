// One renderer an eye, as several GPUs have it, against one for both.
#include "renderer/pipelines/frame/eyes_apart.h"

#include <gtest/gtest.h>

#include "renderer/backends/host_bvh/host_backend.h"
#include "renderer/pipelines/frame/frame_renderer.h"
#include "tests/renderer/pipelines/reprojected_flight.h"

namespace foverig {
namespace {

using FrameTwin = FrameRenderer<host_bvh::HostBackend, ReprojectedFrame>;

EyesApart apart(const std::shared_ptr<const Scene>& scene, const RenderSettings& settings) {
    std::vector<std::unique_ptr<Renderer>> eyes;
    for (int i = 0; i < 2; ++i)
        eyes.push_back(std::make_unique<FrameTwin>(scene, settings, BuildBinary{}));
    return EyesApart(std::move(eyes));
}

TEST(EyesApart, GiveTheFramesOfEyesTogether) {
    const auto scene = builtin("cornell");
    const RenderSettings settings = only_point_light();
    EyesApart two = apart(scene, settings);
    FrameTwin one(scene, settings, {});
    for (int frame = 0; frame < 3; ++frame) {
        FrameInput input = input_at(*scene, frame, false, 90, 70);
        input.eyes.push_back(input.eyes[0]);
        input.eyes[1].view.position_m.x += 0.064F;
        const FrameStats together = one.render(input);
        const FrameStats split = two.render(input);
        EXPECT_EQ(split.rays.total(), together.rays.total());
        EXPECT_EQ(split.all_pixels, together.all_pixels);
        for (int eye = 0; eye < 2; ++eye) {
            EXPECT_EQ(two.image(eye).pixels, one.image(eye).pixels) << frame << ", eye " << eye;
            EXPECT_EQ(two.sampling_mask(eye).pixels, one.sampling_mask(eye).pixels);
        }
    }
    EXPECT_EQ(two.backend_name(), "host-bvh x 2");
}

TEST(EyesApart, RefuseAThirdEye) {
    const auto scene = builtin("cornell");
    EyesApart two = apart(scene, only_point_light());
    FrameInput input = input_at(*scene, 0, false, 90, 70);
    input.eyes.resize(3, input.eyes[0]);
    EXPECT_THROW(two.render(input), std::invalid_argument);
}

}  // namespace
}  // namespace foverig
