#include "simulators/usb/dk2_function.h"

#include <gtest/gtest.h>

#include "devices/crc32.h"
#include "devices/dk2/feature_reports.h"
#include "devices/dk2/identity_reports.h"
#include "simulators/usb/control_endpoint.h"
#include "simulators/usb/dk2_report_descriptor.h"
#include "tests/devices/byte_text.h"
#include "tests/simulators/dk2/dk2_bench.h"

namespace foverig::usb {
namespace {

using test::bytes_of;

constexpr std::uint16_t kFeature = 0x300;

Setup descriptor(std::uint16_t value, std::uint16_t length = 255) {
    return {.type = 0x80, .request = 6, .value = value, .index = 0, .length = length};
}

TEST(Dk2OnUsb, ReportDescriptorIsTheFirmwares) {
    const auto descriptor = dk2_report_descriptor();
    EXPECT_EQ(descriptor.size(), 771u);
    // Of the array in facebookarchive/RiftDK2, Headset/Firmware/src/usb_desc.c.
    EXPECT_EQ(crc32(descriptor), 0x0F98C44Bu);
}

// DEVICES.md 1.1: 20 characters, those of report 19; report 10 has but 12.
TEST(Dk2OnUsb, TheSerialIsTheUuid) {
    test::Dk2Bench bench;
    const Dk2Function function(bench.device);
    const auto uuid = dk2::UuidReport::decode(
        bench.device.control_get(dk2::UuidReport::kId, 0, dk2::UuidReport::kSize).value());
    EXPECT_EQ(function.descriptors().strings[2], uuid->uuid);
    EXPECT_EQ(uuid->uuid.size(), 20u);
    EXPECT_EQ(dk2_serial(bench.device), uuid->uuid);
}

TEST(Dk2OnUsb, DescriptorsAreTheFirmwares) {
    test::Dk2Bench bench;
    Dk2Function function(bench.device);
    ControlEndpoint control(function);
    EXPECT_EQ(control.answer(descriptor(0x0100)),
              bytes_of("12 01 00 02 00 00 00 40 33 28 21 00 12 02 01 02 03 01"));
    EXPECT_EQ(control.answer(descriptor(0x0200)),
              bytes_of("09 02 22 00 01 01 00 a0 32  09 04 00 00 01 03 00 00 00"
                       "09 21 10 01 00 01 22 03 03  07 05 81 03 40 00 01"));
    EXPECT_EQ(control.answer(descriptor(0x0302)),
              bytes_of("12 03 52 00 69 00 66 00 74 00 20 00 44 00 4b 00 32 00"));  // "Rift DK2"
    EXPECT_FALSE(control.answer(descriptor(0x0600))) << "a full-speed device has no qualifier";
    EXPECT_FALSE(control.answer(descriptor(0x0304)));
}

TEST(Dk2OnUsb, DescriptorsAreCutToWhatTheHostAsksFor) {
    test::Dk2Bench bench;
    Dk2Function function(bench.device);
    ControlEndpoint control(function);
    EXPECT_EQ(control.answer(descriptor(0x0100, 8))->size(), 8u);
    EXPECT_EQ(control.answer({.type = 0x81, .request = 6, .value = 0x2200, .length = 771})->size(),
              771u);
}

TEST(Dk2OnUsb, FeatureReportsReachTheModelBothWays) {
    test::Dk2Bench bench;
    Dk2Function function(bench.device);
    ControlEndpoint control(function);
    const dk2::TrackingReport lit{.command_id = 9, .enable = true, .exposure_us = 350};
    EXPECT_TRUE(control.take({.type = 0x21, .request = 9, .value = kFeature | 12, .length = 13},
                             lit.encode()));
    EXPECT_EQ(bench.get<dk2::TrackingReport>().exposure_us, 350);
    const auto display =
        control.answer({.type = 0xA1, .request = 1, .value = kFeature | 13, .length = 255});
    ASSERT_TRUE(display);
    EXPECT_EQ(display->size(), 16u) << "two more than are declared (DEVICES.md 1.1)";
}

TEST(Dk2OnUsb, StallsWhereTheModelRefuses) {
    test::Dk2Bench bench;
    Dk2Function function(bench.device);
    ControlEndpoint control(function);
    EXPECT_FALSE(
        control.answer({.type = 0xA1, .request = 1, .value = kFeature | 99, .length = 64}));
    EXPECT_FALSE(control.answer({.type = 0xA1, .request = 1, .value = 0x10B, .length = 64}));
    EXPECT_FALSE(control.answer({.type = 0xC0, .request = 1, .length = 4}));
    EXPECT_FALSE(control.take({.type = 0x21, .request = 9, .value = kFeature | 3, .length = 69},
                              std::vector<std::byte>(69)));
    EXPECT_TRUE(control.take({.type = 0x21, .request = 10}, {})) << "SET_IDLE, of every HID host";
}

}  // namespace
}  // namespace foverig::usb
