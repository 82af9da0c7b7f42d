// The tracker camera through the kernel's uvcvideo and its quirk for this camera, beside headset
// and gaze tracker. Its frames are numbered patterns: drawing LEDs takes longer than a frame on the
// virtual machine's clock. Its extension unit is the simulated camera's.
#include <cmath>

#include "devices/camera/frame.h"
#include "devices/camera/tracker_camera.h"
#include "devices/gaze/requests.h"
#include "simulators/camera/camera_registers.h"
#include "simulators/usb/camera_descriptors.h"
#include "simulators/usb/camera_function.h"
#include "simulators/usb/exposed_device.h"
#include "simulators/usb/vhci_face.h"
#include "tests/kernel/drivers/desk.h"
#include "tests/kernel/exposed.h"

namespace foverig::test {
namespace {

constexpr Nanoseconds kFrameTime{16'666'667}, kMeasured = 4 * kSecond;

/// Frame n is full of bytes of n, the first eight are n itself.
std::vector<std::byte> pattern(std::uint64_t number) {
    std::vector<std::byte> image(usb::kCameraFrameBytes, static_cast<std::byte>(number * 37));
    write_u64(image, 0, number);
    return image;
}

class NumberedFrames final : public Transport {
  public:
    explicit NumberedFrames(const Clock& clock) : clock_(clock), next_(clock.now()) {}

    NextPacket next(HostTime deadline) override {
        if (deadline < next_) return Timeout{};
        const HostTime due = std::exchange(next_, next_ + kFrameTime);
        return Packet{due, camera::encode_frame({}, pattern(number_++))};
    }
    Status control_set(std::uint8_t id, std::uint16_t, std::span<const std::byte> data) override {
        return registers_.set(id, data);
    }
    Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t,
                                               std::size_t size) override {
        return registers_.get(id, size);
    }

  private:
    const Clock& clock_;
    HostTime next_;
    std::uint64_t number_ = 0;
    CameraRegisters registers_{camera::Lens{}};
};

class TrackerCameraOnUsb : public testing::Test {
  protected:
    void SetUp() override {
        auto begun = usb::ExposedDevice::begin(model, clock, [this] {
            return usb::VhciFace::plug_in(std::make_unique<usb::CameraFunction>(model),
                                          usb::kCameraFrames, clock);
        });
        ASSERT_TRUE(begun) << begun.error().text;
        device = std::move(begun).value();
        link = opened([&] { return hardware::open_tracker_camera(clock, ""); });
        ASSERT_TRUE(link);
    }
    void TearDown() override {
        link.reset();
        device.reset();
    }

    WallClock clock;
    NumberedFrames frames{clock};
    usb::LockedTransport model{frames};
    std::unique_ptr<usb::ExposedDevice> device;
    std::unique_ptr<hardware::LiveTransport> link;
};

TEST_F(TrackerCameraOnUsb, GivesEveryFrameWholeWhileTheOthersStream) {
    Exposed headset_process(std::vector<std::string>{"dk2"});
    Exposed tracker_process(std::vector<std::string>{"gaze"});
    const auto headset_link = headset(clock);
    const auto tracker_link = tracker(clock);
    ASSERT_TRUE(headset_link && tracker_link);
    EXPECT_TRUE(tracker_link->control_set(gaze::request::set_rate, 60, {}));
    EXPECT_TRUE(tracker_link->control_set(gaze::request::start, 0, {}));
    const HostTime from = clock.now() + kSecond, until = from + kMeasured;
    for (auto* other : {link.get(), headset_link.get(), tracker_link.get()}) {
        packets_until(*other, from);
    }
    const auto got = packets_until(*link, until);  // first: it keeps but a few
    const auto reports = packets_until(*headset_link, until);
    const auto gaze_frames = packets_until(*tracker_link, until);

    EXPECT_NEAR(static_cast<double>(got.size()), 240.0, 12.0);  // some may have waited
    std::optional<std::uint64_t> before;
    for (const Packet& packet : got) {
        const auto header = camera::decode_header(packet.bytes);
        ASSERT_TRUE(header);
        ASSERT_EQ(header->format, camera::kGrey) << "the kernel's quirk for 2833:0201";
        ASSERT_EQ(header->width_px, 752);
        ASSERT_EQ(header->height_px, 480);
        ASSERT_FALSE(header->damaged);
        const Bytes image = Bytes(packet.bytes).subspan(camera::FrameHeader::kSize);
        const std::uint64_t number = read_u64(image, 0);
        ASSERT_TRUE(std::ranges::equal(image, pattern(number))) << "frame " << number;
        if (before) {
            ASSERT_EQ(number, *before + 1);
        }
        before = number;
    }
    EXPECT_NEAR(static_cast<double>(reports.size()), 4000.0, 40.0);
    for (std::size_t i = 1; i < reports.size(); ++i) {
        ASSERT_EQ(static_cast<std::uint16_t>(read_u16(reports[i - 1].bytes, 4) + 1),
                  read_u16(reports[i].bytes, 4))
            << "report " << i;
    }
    EXPECT_NEAR(static_cast<double>(gaze_frames.size()), 244.0, 4.0);
}

TEST_F(TrackerCameraOnUsb, AnswersThroughTheKernelsExtensionUnit) {
    using namespace camera;
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

}  // namespace
}  // namespace foverig::test
