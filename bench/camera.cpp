// The tracker camera's steps on one image: spots of light, and the pose they give.
#include <benchmark/benchmark.h>

#include "bench/suites.h"
#include "devices/camera/blobs.h"
#include "devices/camera/led_tracker.h"
#include "simulators/camera/simulated_camera.h"
#include "simulators/dk2/simulated_dk2.h"
#include "simulators/motion/catalog.h"

namespace foverig::bench {
namespace {

constexpr std::uint64_t kSeed = 5;

/// One image of a headset 0.9 m away with the sensor's noise.
class OneImage {
  public:
    OneImage() {
        ManualClock clock;
        const auto still = std::move(motion::make_head("still", kSeed)).value();
        const motion::HeadState head = still->at(0.0);
        SimulatedDk2 dk2(clock, *still);
        leds = dk2::read_leds(dk2).value();
        CameraScene scene(leds, camera::Lens{}, {.noise = 1}, kSeed);
        bytes.resize(static_cast<std::size_t>(kCameraWidth_px) * kCameraHeight_px);
        const RigidPose world_from_imu{head.world_from_head,
                                       head.position_m + head.world_from_head * kImuFromEyes_m};
        truth = usual_camera_place().inverse() * world_from_imu;
        scene.render({.camera_from_imu = truth, .pattern = 3}, bytes);
    }
    camera::GreyView view() const {
        return {kCameraWidth_px, kCameraHeight_px, kCameraWidth_px, bytes};
    }

    std::vector<dk2::Led> leds;
    std::vector<std::byte> bytes;
    RigidPose truth;
};

void BM_CameraBlobs(benchmark::State& state) {
    const OneImage image;
    if (camera::find_blobs(image.view()).size() < 12) {
        return state.SkipWithError("fewer than 12 LEDs are seen");
    }
    for (auto unused : state) benchmark::DoNotOptimize(camera::find_blobs(image.view()));
}

void BM_CameraPose(benchmark::State& state) {
    const OneImage image;
    camera::LedTracker tracker(image.leds, camera::Lens{});
    const auto first = tracker.see(image.view(), 0, 3, image.truth);
    if (!first ||
        glm::distance(first->camera_from_imu.translation_m, image.truth.translation_m) > 0.002) {
        return state.SkipWithError("the pose is not the one that was rendered");
    }
    int exposure = 0;
    for (auto unused : state) {
        benchmark::DoNotOptimize(tracker.see(image.view(), ++exposure, 3, image.truth));
    }
}

}  // namespace

void register_camera() {
    benchmark::RegisterBenchmark("BM_CameraBlobs", BM_CameraBlobs);
    benchmark::RegisterBenchmark("BM_CameraPose", BM_CameraPose);
}

}  // namespace foverig::bench
