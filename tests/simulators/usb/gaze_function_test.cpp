#include "simulators/usb/gaze_function.h"

#include <gtest/gtest.h>

#include "devices/gaze/requests.h"
#include "simulators/usb/control_endpoint.h"
#include "tests/devices/byte_text.h"
#include "tests/simulators/gaze/gaze_bench.h"

namespace foverig::usb {
namespace {

using test::bytes_of;

Setup descriptor(std::uint16_t value, std::uint16_t length = 255) {
    return {.type = 0x80, .request = 6, .value = value, .index = 0, .length = length};
}

TEST(GazeOnUsb, IsTheDocumentedDevice) {
    test::GazeBench bench;
    GazeFunction function(bench.device, {.vendor = 0x1209, .product = 0x0001});
    ControlEndpoint control(function);
    EXPECT_EQ(control.answer(descriptor(0x0100)),
              bytes_of("12 01 00 02 00 00 00 40 09 12 01 00 00 01 01 02 03 01"));
    EXPECT_EQ(control.answer(descriptor(0x0200)),
              bytes_of("09 02 19 00 01 01 00 80 32  09 04 00 00 01 ff 47 01 00"
                       "07 05 81 02 00 02 00"));
    EXPECT_EQ(function.descriptors().strings[2], "FOVERIGSIM000001");
}

TEST(GazeOnUsb, TakesVendorRequestsOfItsInterfaceOnly) {
    test::GazeBench bench;
    GazeFunction function(bench.device, {.vendor = 0x1209, .product = 0x0001});
    ControlEndpoint control(function);
    const auto time = control.answer({.type = 0xC1, .request = 3, .value = 0x1234, .length = 16});
    ASSERT_TRUE(time);
    EXPECT_EQ(gaze::DeviceTimeReply::decode(*time)->cookie, 0x1234);
    EXPECT_FALSE(control.answer({.type = 0xC1, .request = 3, .index = 1, .length = 16}));
    EXPECT_FALSE(control.answer({.type = 0xC1, .request = 3, .length = 15})) << "wrong length";
    EXPECT_FALSE(control.take({.type = 0x41, .request = 0x12, .value = 61}, {})) << "no such rate";
    EXPECT_TRUE(control.take({.type = 0x41, .request = 0x12, .value = 250}, {}));
    EXPECT_TRUE(control.take({.type = 0x41, .request = 0x10}, {}));
    EXPECT_FALSE(control.take({.type = 0x41, .request = 0x10}, {})) << "started already";
}

}  // namespace
}  // namespace foverig::usb
