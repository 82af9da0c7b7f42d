// Frames of the simulated tracker camera, drawn only where there is light, against frames of it
// drawn pixel by pixel; and a headset that is lit for a camera alone.
#include "devices/camera/blobs.h"
#include "devices/crc32.h"
#include "simulators/camera/staged_camera.h"
#include "tests/simulators/camera/camera_bench.h"

namespace foverig {
namespace {

using test::at_s;
using test::CameraBench;

/// CRC-32 of 50 frames of a head that looks around.
std::uint32_t fifty_frames(const CameraFaults& faults) {
    CameraBench bench({.motion = "look"});
    CameraScene scene(bench.leds, camera::Lens{}, faults, 5);
    std::vector<std::byte> image(static_cast<std::size_t>(kCameraWidth_px) * kCameraHeight_px);
    std::uint32_t crc = 0;
    for (std::uint64_t i = 0; i < 50; ++i) {
        scene.render({.camera_from_imu = bench.truth(at_s(0.05 * static_cast<double>(i))),
                      .pattern = static_cast<std::uint8_t>(i % 11),
                      .index = i},
                     image);
        crc = crc32(image, crc);
    }
    return crc;
}

// Golden values: of the code before, which summed light and drew noise for each of 360960 pixels.
TEST(CameraScene, DrawsWhatDrawingEveryPixelDrew) {
    EXPECT_EQ(fifty_frames({}), 0x8AFB102Bu);
    EXPECT_EQ(fifty_frames({.spots = 6}), 0xA5BAFD6Bu);
    EXPECT_EQ(fifty_frames({.noise = 1}), 0x4E076848u);
    EXPECT_EQ(fifty_frames({.noise = 1, .spots = 6}), 0x6E5C55FFu);
}

TEST(CameraScene, LeavesNoLightBehind) {
    CameraBench bench;
    CameraScene scene(bench.leds, camera::Lens{}, {}, 5);
    std::vector<std::byte> image(static_cast<std::size_t>(kCameraWidth_px) * kCameraHeight_px);
    scene.render({.camera_from_imu = bench.truth(at_s(0.0))}, image);
    EXPECT_GT(std::ranges::count_if(image, [](std::byte b) { return b > std::byte{30}; }), 100);
    scene.render({.camera_from_imu = bench.truth(at_s(0.0)), .covered = true}, image);
    EXPECT_EQ(std::ranges::count(image, std::byte{10}), std::ssize(image));
}

TEST(StagedCamera, SeesTheLedsOfAHeadsetThatNobodyElseDrives) {
    CameraBench bench;
    StagedCamera staged(bench.device, bench.dk2, bench.clock);
    (void)staged.next(at_s(0.001));
    camera::Esp570 bridge(staged);
    ASSERT_TRUE(camera::set_up_sensor(bridge, camera::Sync::headset));
    int frames = 0;
    for (double t = 0.01; t < 25.0; t += 0.01) {  // it would sleep after ten seconds
        bench.clock.sleep_until(at_s(t));
        while (true) {
            const auto next = staged.next(at_s(t));
            const auto* packet = std::get_if<Packet>(&next);
            if (packet == nullptr) break;
            ++frames;
            if (frames % 60 != 0) continue;
            const auto header = camera::decode_header(packet->bytes);
            ASSERT_TRUE(header);
            EXPECT_GE(camera::find_blobs(camera::tracker_image(*header, packet->bytes)).size(), 4u);
        }
    }
    EXPECT_NEAR(frames, 25.0 / 0.016666, 3.0);
}

TEST(StagedCamera, LightsAHeadsetAgainThatWasUnplugged) {
    CameraBench bench({.dk2 = {.unplug_at = 2, .unplug_for = 1}});
    StagedCamera staged(bench.device, bench.dk2, bench.clock);
    (void)staged.next(at_s(0.001));
    camera::Esp570 bridge(staged);
    ASSERT_TRUE(camera::set_up_sensor(bridge, camera::Sync::headset));
    int late_frames = 0;
    for (double t = 0.01; t < 10.0; t += 0.01) {
        bench.clock.sleep_until(at_s(t));
        while (std::holds_alternative<Packet>(staged.next(at_s(t)))) late_frames += t > 8.0;
    }
    EXPECT_NEAR(late_frames, 2.0 / 0.016666, 3.0);
}

}  // namespace
}  // namespace foverig
