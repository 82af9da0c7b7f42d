#include "devices/camera/video_camera.h"

#include <gtest/gtest.h>

#include "tests/devices/fake_transport.h"

namespace foverig::camera {
namespace {

constexpr HostTime at_ms(int ms) {
    return HostTime(std::chrono::milliseconds(ms));
}

std::vector<std::byte> frame(std::uint32_t sequence, std::uint8_t level) {
    return encode_frame(
        {.width_px = 2, .height_px = 1, .stride_bytes = 2, .sequence = sequence, .age_us = 5000},
        std::array{std::byte{level}, std::byte{level}});
}

class AnyVideoCamera : public testing::Test {
  protected:
    test::FakeTransport transport;
    VideoCamera camera{transport};
};

TEST_F(AnyVideoCamera, ShowsTheNewestFrameAndCountsAll) {
    EXPECT_FALSE(camera.read_until(at_ms(5)));
    EXPECT_EQ(camera.image(), nullptr);
    for (std::uint32_t i = 0; i < 4; ++i) {
        transport.push(at_ms(10 + static_cast<int>(i)),
                       frame(i, static_cast<std::uint8_t>(50 + i)));
    }
    EXPECT_TRUE(camera.read_until(at_ms(12)));
    EXPECT_EQ(camera.newest()->arrival, at_ms(12));
    EXPECT_EQ(camera.newest()->stamp, at_ms(7));
    EXPECT_EQ(camera.image()->bytes.front(), 52);
    EXPECT_EQ(camera.counts().samples, 3u);
    EXPECT_TRUE(camera.read_until(at_ms(20)));
    EXPECT_EQ(camera.image()->bytes.front(), 53);
    EXPECT_FALSE(camera.read_until(at_ms(30))) << "nothing new";
    EXPECT_EQ(camera.image()->bytes.front(), 53) << "it stands";
    EXPECT_EQ(camera.counts().samples, 4u);
    EXPECT_EQ(camera.counts().lost, 0u);
}

TEST_F(AnyVideoCamera, CountsWhatTheDriverLostAndWhatIsBroken) {
    auto damaged = frame(5, 1);
    damaged[24] = std::byte{1};
    transport.push(at_ms(1), frame(2, 10));
    transport.push(at_ms(2), frame(4, 20));
    transport.push(at_ms(3), damaged);
    transport.push(at_ms(4), std::vector<std::byte>(7));
    transport.push(
        at_ms(5),
        encode_frame(
            {.format = kMjpeg, .width_px = 2, .height_px = 1, .stride_bytes = 0, .sequence = 6},
            std::array<std::byte, 9>{}));
    EXPECT_TRUE(camera.read_until(at_ms(10)));
    EXPECT_EQ(camera.image(), nullptr) << "no JPEG";
    EXPECT_EQ(camera.image(), nullptr);
    EXPECT_EQ(camera.counts().lost, 2u);      // 3, and 5, whose number nobody may trust
    EXPECT_EQ(camera.counts().rejected, 3u);  // the broken one is counted once
    EXPECT_EQ(camera.counts().samples, 2u);
}

TEST_F(AnyVideoCamera, HasNoPictureWhileItIsUnplugged) {
    transport.push(at_ms(1), frame(70, 10));
    transport.fault_at_end = Error{ErrorCode::closed, "unplugged"};
    EXPECT_FALSE(camera.read_until(at_ms(2)));
    EXPECT_EQ(camera.image(), nullptr);
    transport.fault_at_end.reset();
    transport.push(at_ms(5), frame(0, 30));
    EXPECT_TRUE(camera.read_until(at_ms(6)));
    EXPECT_EQ(camera.image()->bytes.front(), 30);
    EXPECT_EQ(camera.counts().reconnects, 1u);
    EXPECT_EQ(camera.counts().lost, 0u);
}

}  // namespace
}  // namespace foverig::camera
