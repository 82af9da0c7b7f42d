#include "devices/dk2/input_reports.h"

#include <gtest/gtest.h>

#include "tests/devices/byte_text.h"

namespace foverig::dk2 {
namespace {

using test::bytes_of;
using test::copy_of;

// DEVICES.md 1.2, golden report 11.
constexpr const char* kGolden =
    "0b 07 00 02 34 12 35 0c 4e 61 bc 00 00 00 00 5f"
    "c4 80 00 00 00 00 57 ff fb 00 00 3c 00 03 c0 5f"
    "b4 3f ff 92 00 00 67 ff fb 80 00 42 34 08 34 ef"
    "dc 05 f4 01 00 50 bc 00 50 03 2c 01 00 58 bc 00";

InputReport11 golden() {
    InputReport11 r;
    r.last_command_id = 7;
    r.num_samples = 2;
    r.sample_count = 0x1234;
    r.temperature_centi_c = 3125;
    r.sample_timestamp_us = 0x00BC614E;
    r.slots = {InertialSlot{{0, 98066, 0}, {10, -20, 30}},
               InertialSlot{{120, 98000, -55}, {12, -18, 33}}};
    r.mag_1e4_gauss = {2100, -4300, 1500};
    r.frame_count = 500;
    r.frame_timestamp_us = 0x00BC5000;
    r.frame_id = 80;
    r.tracking_pattern = 3;
    r.tracking_count = 300;
    r.tracking_timestamp_us = 0x00BC5800;
    return r;
}

TEST(InputReport11, DecodesTheGoldenReport) {
    const auto report = InputReport11::decode(bytes_of(kGolden));
    ASSERT_TRUE(report);
    EXPECT_EQ(*report, golden());
}

TEST(InputReport11, EncodesTheGoldenReport) {
    EXPECT_EQ(copy_of(golden().encode()), bytes_of(kGolden));
}

TEST(InputReport11, RejectsEveryOtherLength) {
    std::vector<std::byte> bytes = bytes_of(kGolden);
    bytes.resize(70);
    for (std::size_t n = 0; n <= bytes.size(); ++n) {
        EXPECT_EQ(static_cast<bool>(InputReport11::decode(Bytes(bytes).first(n))), n == 64) << n;
    }
}

TEST(InputReport11, RejectsAForeignId) {
    std::vector<std::byte> bytes = bytes_of(kGolden);
    bytes[0] = std::byte{12};
    const auto report = InputReport11::decode(bytes);
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().code, ErrorCode::invalid_data);
    EXPECT_NE(report.error().text.find("id 12"), std::string::npos);
}

TEST(InputReport11, RejectsSampleNumbersThatTheFirmwareNeverSends) {
    std::vector<std::byte> bytes = bytes_of(kGolden);
    for (int n = 0; n < 256; ++n) {
        bytes[3] = static_cast<std::byte>(n);
        EXPECT_EQ(static_cast<bool>(InputReport11::decode(bytes)), n >= 1 && n <= 254) << n;
    }
}

TEST(InputReport11, RandomBytesNeitherCrashNorChangeInARoundTrip) {
    test::Random random(11);
    int accepted = 0;
    for (int i = 0; i < 20000; ++i) {
        std::vector<std::byte> bytes = random.bytes(random.bits() % 80);
        if (!bytes.empty() && i % 2 == 0) {
            bytes.resize(64);
            bytes[0] = std::byte{11};
        }
        const auto report = InputReport11::decode(bytes);
        if (!report) continue;
        ++accepted;
        const auto again = InputReport11::decode(report->encode());
        ASSERT_TRUE(again);
        ASSERT_EQ(*again, *report);
    }
    EXPECT_GT(accepted, 9000);
}

TEST(InputReport1, LaysItsFieldsOutAsTheDk1) {
    // Offsets of DEVICES.md 1.2: id, N, count, command, temperature, three slots, magnetometer.
    InputReport1 r;
    r.num_samples = 3;
    r.sample_count = 0x0201;
    r.last_command_id = 0x0403;
    r.temperature_centi_c = -2;
    r.slots[0].accel = {1, 0, 0};
    r.slots[1].gyro = {0, 1, 0};
    r.slots[2].gyro = {0, 0, 1};
    r.mag_1e4_gauss = {0x0605, 0x0807, -1};
    EXPECT_EQ(copy_of(r.encode()), bytes_of("01 03 01 02 03 04 fe ff"
                                            "00 00 08 00 00 00 00 00 00 00 00 00 00 00 00 00"
                                            "00 00 00 00 00 00 00 00 00 00 00 00 00 40 00 00"
                                            "00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 02"
                                            "05 06 07 08 ff ff"));
    const auto decoded = InputReport1::decode(r.encode());
    ASSERT_TRUE(decoded);
    EXPECT_EQ(*decoded, r);
}

TEST(InputReport1, AcceptsPaddingToTheEndpointAndRejectsTruncation) {
    std::vector<std::byte> bytes = copy_of(InputReport1{}.encode());
    bytes.resize(66);
    for (std::size_t n = 0; n <= bytes.size(); ++n) {
        EXPECT_EQ(static_cast<bool>(InputReport1::decode(Bytes(bytes).first(n))),
                  n >= 62 && n <= 64)
            << n;
    }
}

}  // namespace
}  // namespace foverig::dk2
