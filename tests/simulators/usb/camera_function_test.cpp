#include "simulators/usb/camera_function.h"

#include <gtest/gtest.h>

#include "devices/camera/frame.h"
#include "simulators/usb/camera_descriptors.h"
#include "simulators/usb/control_endpoint.h"
#include "tests/devices/byte_text.h"
#include "tests/devices/fake_transport.h"

namespace foverig::usb {
namespace {

using test::bytes_of;
using test::FakeTransport;

constexpr std::uint16_t kUnit4 = 0x0400, kStreaming = 1;

/// 26 bytes of UVC 1.0's table 4-47: format 1, frame 1, 166667 x 100 ns, 360960 bytes, 16384 at a
/// time.
constexpr const char* kStream = "0000 01 01 0b8b0200 0000 0000 0000 0000 0000 00820500 00400000";

std::vector<std::byte> frame_of(Bytes image) {
    return camera::encode_frame({.sequence = 1}, image);
}

class CameraOnUsb : public testing::Test {
  protected:
    bool commit() {
        return control.take(
            {.type = 0x21, .request = 1, .value = 0x0200, .index = kStreaming, .length = 26},
            bytes_of(kStream));
    }

    FakeTransport device;
    CameraFunction function{device};
    ControlEndpoint control{function};
};

TEST_F(CameraOnUsb, DescriptorsFillTheConfigurationExactly) {
    const auto all = *control.answer({.type = 0x80, .request = 6, .value = 0x0200, .length = 4096});
    EXPECT_EQ(read_u16(all, 2), all.size());
    std::vector<int> kinds;
    for (std::size_t at = 0; at < all.size(); at += read_u8(all, at)) {
        ASSERT_GE(read_u8(all, at), 2);
        ASSERT_LE(at + read_u8(all, at), all.size());
        kinds.push_back(read_u8(all, at + 1));
    }
    // Configuration, association, control interface with 4 class descriptors, streaming interface
    // with 3, endpoint.
    EXPECT_EQ(kinds, (std::vector{2, 11, 4, 0x24, 0x24, 0x24, 0x24, 4, 0x24, 0x24, 0x24, 5}));
}

TEST_F(CameraOnUsb, OffersOneStreamOfHalfTheWidth) {
    for (const std::uint8_t request : std::initializer_list<std::uint8_t>{0x81, 0x82, 0x83, 0x87}) {
        EXPECT_EQ(control.answer({.type = 0xA1,
                                  .request = request,
                                  .value = 0x0100,
                                  .index = kStreaming,
                                  .length = 26}),
                  bytes_of(kStream));
    }
    const auto interfaces = camera_interfaces(dk2_camera());
    // USB Video Payload Uncompressed, 2.2: the GUID of YUY2.
    const auto guid = bytes_of("5955593200001000800000aa00389b71");
    const auto found = std::search(interfaces.begin(), interfaces.end(), guid.begin(), guid.end());
    EXPECT_NE(found, interfaces.end());
}

TEST_F(CameraOnUsb, SendsNothingUntilAStreamIsCommitted) {
    const std::vector<std::byte> image(kCameraFrameBytes, std::byte{7});
    EXPECT_TRUE(function.transfers(frame_of(image)).empty());
    EXPECT_TRUE(commit());
    EXPECT_FALSE(function.transfers(frame_of(image)).empty());
    EXPECT_TRUE(function.transfers(bytes_of("00")).empty()) << "no frame";
}

TEST_F(CameraOnUsb, CutsFramesIntoPayloadsWithATogglingBitAndAnEnd) {
    ASSERT_TRUE(commit());
    const auto image = test::Random(1).bytes(kCameraFrameBytes);
    std::vector<std::byte> together;
    const auto payloads = function.transfers(frame_of(image));
    ASSERT_EQ(payloads.size(), 23u);  // 360960 / 16382, rounded up
    for (std::size_t i = 0; i < payloads.size(); ++i) {
        EXPECT_LE(payloads[i].size(), kCameraPayload);
        EXPECT_EQ(read_u8(payloads[i], 0), 2);
        EXPECT_EQ(read_u8(payloads[i], 1), i + 1 < payloads.size() ? 0x81 : 0x83);
        together.insert(together.end(), payloads[i].begin() + 2, payloads[i].end());
    }
    EXPECT_EQ(together, image);
    EXPECT_EQ(read_u8(function.transfers(frame_of(image)).front(), 1), 0x80);
}

TEST_F(CameraOnUsb, ExtensionUnitIsTheModels) {
    device.answers[2] = bytes_of("8413240000 00");
    EXPECT_EQ(control.answer(
                  {.type = 0xA1, .request = 0x85, .value = 0x0500, .index = kUnit4, .length = 2}),
              bytes_of("3b00"));  // 59 bytes
    EXPECT_EQ(control.answer(
                  {.type = 0xA1, .request = 0x81, .value = 0x0200, .index = kUnit4, .length = 6}),
              device.answers[2]);
    EXPECT_TRUE(
        control.take({.type = 0x21, .request = 1, .value = 0x0200, .index = kUnit4, .length = 6},
                     bytes_of("849800000000")));
    ASSERT_EQ(device.sets.size(), 1u);
    EXPECT_EQ(device.sets[0].id, 2);
    EXPECT_EQ(device.sets[0].value, 4);
}

// DEVICES.md 1.8.1: "3-4". The shorter one finds a driver that does not ask.
TEST_F(CameraOnUsb, TheUnknownSelectorHasThreeBytes) {
    EXPECT_EQ(control.answer(
                  {.type = 0xA1, .request = 0x85, .value = 0x0300, .index = kUnit4, .length = 2}),
              bytes_of("0300"));
}

TEST_F(CameraOnUsb, StallsWhatIsNotThereAndSaysWhy) {
    EXPECT_FALSE(control.answer(
        {.type = 0xA1, .request = 0x85, .value = 0x0700, .index = kUnit4, .length = 2}));
    EXPECT_FALSE(control.answer(
        {.type = 0xA1, .request = 0x81, .value = 0x0200, .index = 0x0900, .length = 6}));
    device.refuse_sets = true;
    EXPECT_FALSE(
        control.take({.type = 0x21, .request = 1, .value = 0x0200, .index = kUnit4, .length = 6},
                     bytes_of("849800000000")));
    // Request error code: invalid control (UVC 1.0, 4.2.1.2).
    EXPECT_EQ(control.answer({.type = 0xA1, .request = 0x81, .value = 0x0200, .length = 1}),
              bytes_of("06"));
}

}  // namespace
}  // namespace foverig::usb
