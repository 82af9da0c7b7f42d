#include "devices/dk2/feature_reports.h"

#include <gtest/gtest.h>

#include "devices/dk2/calibration_reports.h"
#include "devices/dk2/identity_reports.h"
#include "tests/devices/byte_text.h"

namespace foverig::dk2 {
namespace {

using test::bytes_of;
using test::copy_of;

// The byte strings are laid out by hand from the offset tables of DEVICES.md 1.5.

TEST(ConfigReport, PowerOnFlagsAre0x2C) {
    EXPECT_EQ(copy_of(ConfigReport{}.encode()), bytes_of("02 00 00 2c 00 e8 03"));
}

TEST(ConfigReport, EachFlagHasItsBit) {
    bool ConfigReport::*const flags[] = {&ConfigReport::raw,
                                         &ConfigReport::calibration_test,
                                         &ConfigReport::use_calibration,
                                         &ConfigReport::auto_calibration,
                                         &ConfigReport::motion_keep_alive,
                                         &ConfigReport::command_keep_alive,
                                         &ConfigReport::sensor_coordinates,
                                         &ConfigReport::override_power};
    for (int i = 0; i < 8; ++i) {
        std::vector<std::byte> bytes = bytes_of("02 00 00 00 00 e8 03");
        bytes[3] = static_cast<std::byte>(1 << i);
        const auto report = ConfigReport::decode(bytes);
        ASSERT_TRUE(report);
        for (int j = 0; j < 8; ++j) EXPECT_EQ((*report).*flags[j], i == j);
    }
}

TEST(RangeReport, DefaultsAreTheDk2s) {
    EXPECT_EQ(copy_of(RangeReport{}.encode()), bytes_of("04 00 00 04 d0 07 a0 0f"));
}

TEST(RegisterReport, NamesChipAddressAndPayload) {
    const RegisterReport r{.command_id = 0x0201,
                           .chip = RegisterReport::Chip::mpu6500,
                           .address = 0x1B,
                           .payload = 0x18};
    EXPECT_EQ(copy_of(r.encode()), bytes_of("05 01 02 03 1b 18"));
    EXPECT_EQ(*RegisterReport::decode(r.encode()), r);
}

TEST(Dk1KeepAliveReport, HoldsMilliseconds) {
    EXPECT_EQ(copy_of(Dk1KeepAliveReport{.command_id = 0x0102, .timeout_ms = 1000}.encode()),
              bytes_of("08 02 01 e8 03"));
}

TEST(KeepAliveMuxReport, SelectsReport11For10Seconds) {
    EXPECT_EQ(copy_of(KeepAliveMuxReport{}.encode()), bytes_of("11 00 00 0b 10 27"));
}

TEST(DisplayInfoReport, DefaultsAreTheFirmwares) {
    std::vector<std::byte> expected = bytes_of(
        "09 00 00 01 80 07 38 04 40 eb 01 00 54 14 01 00"
        "2a 8a 00 00 0c f8 00 00 c4 9a 00 00 c4 9a 00 00");
    expected.resize(56);
    EXPECT_EQ(copy_of(DisplayInfoReport{}.encode()), expected);
}

TEST(DisplayInfoReport, KIsFourByteFloats) {
    DisplayInfoReport r;
    r.distortion_k[5] = -1.5f;
    EXPECT_EQ(copy_of(Bytes(r.encode()).last(4)), bytes_of("00 00 c0 bf"));
    EXPECT_EQ(*DisplayInfoReport::decode(r.encode()), r);
}

TEST(SerialReport, CutsPadsAndKeepsToAscii) {
    const auto padded = SerialReport::decode(SerialReport{.serial = "DK2ABC"}.encode());
    ASSERT_TRUE(padded);
    EXPECT_EQ(padded->serial, "DK2ABC");
    EXPECT_EQ(SerialReport::decode(SerialReport{.serial = "ABCDEFGHIJKLMN"}.encode())->serial,
              "ABCDEFGHIJKL");
    EXPECT_EQ(SerialReport::decode(SerialReport{.serial = "A\x1B\xFFZ"}.encode())->serial, "A??Z");
}

TEST(TrackingReport, LibOvrsBlinkingSetting) {
    TrackingReport r;
    r.enable = true;
    r.exposure_us = 350;
    r.frame_interval_us = 16666;
    r.duty = 0x7F;
    EXPECT_EQ(copy_of(r.encode()), bytes_of("0c 00 00 00 07 00 5e 01 1a 41 00 00 7f"));
}

TEST(DisplayReport, DefaultsAndReadPixelBit) {
    // shutter 3 | rolling bit 6 | reverse bit 7 = 0xC3; 435, 100 and 1933.
    EXPECT_EQ(copy_of(DisplayReport{}.encode()),
              bytes_of("0d 00 00 ff c3 00 00 00 b3 01 00 00 64 00 8d 07"));
    EXPECT_EQ(read_u32(DisplayReport{.read_pixel = true}.encode(), 4), 0x4C3u);
}

TEST(FactoryCalibrationReport, LaysTriplesOutInOrder) {
    FactoryCalibrationReport r;
    r.accel_offset = {1, 0, 0};
    r.gyro_offset = {0, 1, 0};
    r.accel_rows[2] = {0, 0, 1};
    r.gyro_rows[0] = {-1, -1, -1};
    r.temperature_centi_c = 2500;
    const auto b = r.encode();
    EXPECT_EQ(copy_of(std::span(b).subspan(3, 8)), bytes_of("00 00 08 00 00 00 00 00"));
    EXPECT_EQ(copy_of(std::span(b).subspan(11, 8)), bytes_of("00 00 00 00 00 40 00 00"));
    EXPECT_EQ(copy_of(std::span(b).subspan(35, 8)), bytes_of("00 00 00 00 00 00 00 02"));
    EXPECT_EQ(copy_of(std::span(b).subspan(43, 8)), bytes_of("FF FF FF FF FF FF FF FE"));
    EXPECT_EQ(read_s16(b, 67), 2500);
    EXPECT_EQ(*FactoryCalibrationReport::decode(b), r);
}

TEST(MagCalibrationReport, IsAVersionAndTwelveNumbersByRows) {
    MagCalibrationReport r{.version = 2};
    r.rows[0][1] = 0x01020304;
    r.rows[2][3] = -1;
    std::vector<std::byte> expected = bytes_of("0e 00 00 02 00 00 00 00 04 03 02 01");
    expected.resize(48);
    for (const std::byte b : bytes_of("ff ff ff ff")) expected.push_back(b);
    EXPECT_EQ(copy_of(r.encode()), expected);
    EXPECT_EQ(*MagCalibrationReport::decode(r.encode()), r);
}

TEST(ManufacturingReport, RoundTripsAtItsOffsets) {
    const ManufacturingReport r{.stages = 6,
                                .stage = 5,
                                .stage_version = 2,
                                .location = 0x6B01,
                                .unix_time_s = 0x53C00000,
                                .result = 1};
    EXPECT_EQ(copy_of(r.encode()), bytes_of("12 00 00 06 05 02 01 6b 00 00 c0 53 01 00 00 00"));
    EXPECT_EQ(*ManufacturingReport::decode(r.encode()), r);
}

TEST(UuidReport, IsTwentyCharacters) {
    const UuidReport r{.uuid = "ABCDEFGHIJKLMNOPQRST"};
    EXPECT_EQ(copy_of(r.encode()),
              bytes_of("13 00 00 41 42 43 44 45 46 47 48 49 4a 4b 4c 4d 4e 4f 50 51 52 53 54"));
    EXPECT_EQ(UuidReport::decode(r.encode())->uuid, r.uuid);
}

TEST(TemperatureReport, RoundTripsAtItsOffsets) {
    const TemperatureReport r{.version = 2,
                              .bin = 3,
                              .sample = 4,
                              .target_centi_c = 3000,
                              .actual_centi_c = -1,
                              .unix_time_s = 0x01020304,
                              .gyro_offset = {5, -6, 7}};
    EXPECT_EQ(copy_of(Bytes(r.encode()).first(16)),
              bytes_of("14 00 00 02 07 03 05 04 b8 0b ff ff 04 03 02 01"));
    EXPECT_EQ(*TemperatureReport::decode(r.encode()), r);
}

TEST(GyroOffsetReport, RoundTripsAtItsOffsets) {
    const GyroOffsetReport r{
        .version = 2, .offset = {1, 0, 0}, .time_us = 0x01020304, .temperature_centi_c = 100};
    EXPECT_EQ(copy_of(r.encode()),
              bytes_of("15 00 00 02 00 00 08 00 00 00 00 00 04 03 02 01 64 00"));
    EXPECT_EQ(*GyroOffsetReport::decode(r.encode()), r);
}

TEST(LensDistortionReport, HoldsTheFirmwaresK) {
    const auto b = LensDistortionReport{}.encode();
    EXPECT_EQ(read_u16(b, 12), 16433);
    EXPECT_EQ(read_u16(b, 32), 22610);
    EXPECT_NEAR(read_u16(b, 36) / 524288.0, 0.0360, 1e-6);
    EXPECT_NEAR((read_u16(b, 42) - 0x8000) / 524288.0, 0.025, 1e-6);
    EXPECT_EQ(*LensDistortionReport::decode(b), LensDistortionReport{});
}

template <class Report>
class EveryFeatureReport : public testing::Test {};
using AllReports =
    testing::Types<ConfigReport, FactoryCalibrationReport, RangeReport, RegisterReport,
                   Dk1KeepAliveReport, MagCalibrationReport, ManufacturingReport, UuidReport,
                   DisplayInfoReport, SerialReport, TrackingReport, DisplayReport,
                   KeepAliveMuxReport, TemperatureReport, GyroOffsetReport, LensDistortionReport>;
TYPED_TEST_SUITE(EveryFeatureReport, AllReports);

TYPED_TEST(EveryFeatureReport, RejectsEveryOtherLengthAndId) {
    std::vector<std::byte> bytes = copy_of(TypeParam{}.encode());
    bytes.resize(TypeParam::kSize + 3);
    for (std::size_t n = 0; n <= bytes.size(); ++n) {
        EXPECT_EQ(static_cast<bool>(TypeParam::decode(Bytes(bytes).first(n))),
                  n == TypeParam::kSize)
            << n;
    }
    for (int id = 0; id < 256; ++id) {
        bytes[0] = static_cast<std::byte>(id);
        EXPECT_EQ(static_cast<bool>(TypeParam::decode(Bytes(bytes).first(TypeParam::kSize))),
                  id == TypeParam::kId);
    }
}

TYPED_TEST(EveryFeatureReport, RandomBytesSurviveASecondRoundTrip) {
    test::Random random(TypeParam::kId);
    for (int i = 0; i < 500; ++i) {
        std::vector<std::byte> bytes = random.bytes(TypeParam::kSize);
        bytes[0] = std::byte{TypeParam::kId};
        const auto report = TypeParam::decode(bytes);
        ASSERT_TRUE(report);
        const auto once = report->encode();
        ASSERT_EQ(copy_of(TypeParam::decode(once)->encode()), copy_of(once));
    }
}

}  // namespace
}  // namespace foverig::dk2
