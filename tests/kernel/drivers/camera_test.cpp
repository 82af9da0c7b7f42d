// Cameras through the kernel's uvcvideo: the tracker camera's extension unit, and a camera like any
// other, whose size and rate are chosen of what it offers. (The tracker camera's stream is
// streams_test.cpp's.)
#include <algorithm>

#include "devices/camera/rgb_image.h"
#include "devices/camera/tracker_camera.h"
#include "devices/hardware/found_cameras.h"
#include "simulators/camera/camera_registers.h"
#include "simulators/camera/room_camera.h"
#include "simulators/usb/camera_descriptors.h"
#include "simulators/usb/camera_function.h"
#include "simulators/usb/exposed_device.h"
#include "simulators/usb/vhci_face.h"
#include "tests/kernel/drivers/desk.h"

namespace foverig::test {
namespace {

/// A camera that answers, and never sends a frame.
class AnsweringCamera final : public Transport {
  public:
    NextPacket next(HostTime) override { return Timeout{}; }
    Status control_set(std::uint8_t id, std::uint16_t, std::span<const std::byte> data) override {
        return registers_.set(id, data);
    }
    Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t,
                                               std::size_t size) override {
        return registers_.get(id, size);
    }

  private:
    CameraRegisters registers_{camera::Lens{}};
};

/// A room that turns before its camera; remembers what was sent.
class RememberedRoom final : public Transport {
  public:
    explicit RememberedRoom(Clock& clock)
        : room_(
              clock,
              [](HostTime t) {
                  const double angle_rad = 0.3 * to_seconds(t.time_since_epoch());
                  return RigidPose{glm::angleAxis(angle_rad, dvec3(0, 1, 0)), dvec3(0)};
              },
              60.0) {}

    NextPacket next(HostTime deadline) override {
        NextPacket got = room_.next(deadline);
        if (const auto* packet = std::get_if<Packet>(&got))
            sent.push_back(to_vector(packet->bytes));
        return got;
    }
    Status control_set(std::uint8_t id, std::uint16_t value,
                       std::span<const std::byte> data) override {
        return room_.control_set(id, value, data);
    }
    Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t value,
                                               std::size_t size) override {
        return room_.control_get(id, value, size);
    }
    std::vector<std::vector<std::byte>> sent;

  private:
    RoomCamera room_;
};

std::unique_ptr<usb::ExposedDevice> exposed(usb::LockedTransport& model, Clock& clock,
                                            const usb::CameraTraits& traits) {
    auto begun = usb::ExposedDevice::begin(model, clock, [&model, &clock, traits] {
        return usb::VhciFace::plug_in(std::make_unique<usb::CameraFunction>(model, traits),
                                      usb::kCameraFrames, clock);
    });
    EXPECT_TRUE(begun) << begun.error().text;
    return begun ? std::move(begun).value() : nullptr;
}

TEST(TrackerCameraOnUsb, AnswersThroughTheKernelsExtensionUnit) {
    using namespace camera;
    WallClock clock;
    AnsweringCamera answering;
    usb::LockedTransport model(answering);
    const auto device = exposed(model, clock, usb::dk2_camera());
    const auto link = opened([&] { return hardware::open_tracker_camera(clock, ""); });
    ASSERT_TRUE(device && link);
    Esp570 bridge(*link);
    const auto chip = bridge.read_register(i2c::kSensor, mt9v034::kRegChipVersion);
    ASSERT_TRUE(chip) << chip.error().text;
    EXPECT_EQ(*chip, 0x1324);
    EXPECT_TRUE(bridge.write_register(i2c::kSensor, mt9v034::kRegAnalogGain, 17));
    EXPECT_EQ(*bridge.read_register(i2c::kSensor, mt9v034::kRegAnalogGain), 17);
    const auto refused = link->control_get(7, kExtensionUnit, 4);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::unsupported);

    const auto source = TrackerCamera::open(*link, Sync::free_running);
    ASSERT_TRUE(source) << source.error().text;
    EXPECT_TRUE(source->calibrated()) << "the lens of its EEPROM";
}

TEST(AnyCameraOnUsb, GivesEveryFrameOfTheNearestSizeAndRate) {
    constexpr hardware::UsbId kId{0x1209, 0x0003};
    WallClock clock;
    RememberedRoom room(clock);
    usb::LockedTransport model(room);
    auto device = exposed(model, clock, usb::room_camera());
    auto link = opened([&] {
        return hardware::open_video_camera(clock, hardware::text_of(kId),
                                           {.width_px = 800, .height_px = 600, .rate_hz = 60});
    });
    ASSERT_TRUE(device && link);
    const auto found = hardware::find_cameras_of(kId);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].serial, "FOVERIGSIMROOM");
    const HostTime from = clock.now() + kSecond / 2, until = from + 2 * kSecond;
    packets_until(*link, from);
    const auto got = packets_until(*link, until);
    EXPECT_EQ(link->control_get(2, 4, 6).error().code, ErrorCode::unsupported) << "no such unit";
    link.reset();
    device.reset();

    EXPECT_NEAR(static_cast<double>(got.size()), 60.0, 2.0);
    const auto same = [&got](std::size_t i, Bytes sent) {
        return std::ranges::equal(Bytes(got[i].bytes).subspan(camera::FrameHeader::kSize),
                                  sent.subspan(camera::FrameHeader::kSize));
    };
    ASSERT_FALSE(got.empty());
    auto at = std::ranges::find_if(room.sent, [&](Bytes sent) { return same(0, sent); });
    std::optional<std::uint32_t> before;
    for (std::size_t i = 0; i < got.size(); ++i, ++at) {
        const auto header = camera::decode_any_header(got[i].bytes);
        ASSERT_TRUE(header) << header.error().text;
        ASSERT_EQ(header->format, camera::kYuyv);
        ASSERT_EQ(header->width_px, 640);
        ASSERT_EQ(header->height_px, 480);
        ASSERT_FALSE(header->damaged);
        ASSERT_EQ(header->sequence, before.value_or(header->sequence - 1) + 1);
        before = header->sequence;
        ASSERT_NE(at, room.sent.end()) << "frame " << i << " was never sent";
        ASSERT_TRUE(same(i, *at)) << "frame " << i;
    }
    camera::RgbImage image;
    EXPECT_TRUE(
        camera::to_rgb(*camera::decode_any_header(got.back().bytes), got.back().bytes, image));
    EXPECT_EQ(image.bytes.size(), 640u * 480u * 3u);
}

}  // namespace
}  // namespace foverig::test
