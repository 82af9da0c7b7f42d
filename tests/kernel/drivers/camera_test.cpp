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
#include "tests/devices/camera/jpeg_of.h"
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

RigidPose turning(double seconds) {
    return {glm::angleAxis(0.3 * seconds, dvec3(0, 1, 0)), dvec3(0)};
}

/// What a camera that compresses sees of the room, no two of one size; made before it is needed, as
/// the virtual machine takes longer for one than a frame lasts.
std::vector<std::vector<std::byte>> jpegs_of_room() {
    constexpr int kWidth_px = RoomCamera::kWidth_px, kHeight_px = RoomCamera::kHeight_px;
    const RoomView view(kWidth_px, kHeight_px, camera::ideal_lens(kWidth_px, kHeight_px, 60.0));
    std::vector<std::byte> yuyv(std::size_t{2} * kWidth_px * kHeight_px);
    camera::RgbImage rgb;
    std::vector<std::vector<std::byte>> jpegs;
    for (int i = 0; i < 7; ++i) {
        view.render(turning(i), yuyv);
        const auto frame = camera::encode_frame({.format = camera::kYuyv,
                                                 .width_px = kWidth_px,
                                                 .height_px = kHeight_px,
                                                 .stride_bytes = 2 * kWidth_px},
                                                yuyv);
        EXPECT_TRUE(camera::to_rgb(camera::decode_header(frame).value(), frame, rgb));
        jpegs.push_back(jpeg_of(rgb));
    }
    return jpegs;
}

/// A room that turns before its camera; remembers what was sent.
class RememberedRoom final : public Transport {
  public:
    RememberedRoom(Clock& clock, bool jpeg)
        : jpegs_(jpeg ? jpegs_of_room() : std::vector<std::vector<std::byte>>{}),
          room_(
              clock, [](HostTime t) { return turning(to_seconds(t.time_since_epoch())); },
              camera::ideal_lens(RoomCamera::kWidth_px, RoomCamera::kHeight_px, 60.0)) {}

    NextPacket next(HostTime deadline) override {
        NextPacket got = room_.next(deadline);
        if (auto* packet = std::get_if<Packet>(&got)) {
            if (!jpegs_.empty()) packet->bytes = compressed(packet->bytes);
            sent.push_back(to_vector(packet->bytes));
        }
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
    std::vector<std::byte> compressed(Bytes frame) const {
        auto header = camera::decode_header(frame).value();
        header.format = camera::kMjpeg;
        header.stride_bytes = 0;
        return camera::encode_frame(header, jpegs_[sent.size() % jpegs_.size()]);
    }

    std::vector<std::vector<std::byte>> jpegs_;
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

void expect_every_frame_of_nearest_size_and_rate(const usb::CameraTraits& traits) {
    const hardware::UsbId id{traits.vendor, traits.product};
    WallClock clock;
    RememberedRoom room(clock, traits.jpeg);
    usb::LockedTransport model(room);
    auto device = exposed(model, clock, traits);
    auto link = opened([&] {
        return hardware::open_video_camera(clock, hardware::text_of(id),
                                           {.width_px = 800, .height_px = 600, .rate_hz = 60});
    });
    ASSERT_TRUE(device && link);
    const auto found = hardware::find_cameras_of(id);
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
        ASSERT_EQ(header->format, traits.jpeg ? camera::kMjpeg : camera::kYuyv);
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

TEST(AnyCameraOnUsb, GivesEveryFrameOfTheNearestSizeAndRate) {
    expect_every_frame_of_nearest_size_and_rate(usb::room_camera());
}

TEST(AnyCameraOnUsb, GivesEveryJpegWhateverItsSize) {
    usb::CameraTraits traits = usb::room_camera();
    traits.jpeg = true;
    expect_every_frame_of_nearest_size_and_rate(traits);
}

}  // namespace
}  // namespace foverig::test
