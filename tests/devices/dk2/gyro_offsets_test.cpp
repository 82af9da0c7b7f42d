#include "devices/dk2/gyro_offsets.h"

#include <gtest/gtest.h>

#include "tests/devices/byte_text.h"
#include "tests/devices/fake_transport.h"

namespace foverig::dk2 {
namespace {

constexpr double kUnit_rad_s = 1e-4;  // of the reports
const dvec3 kFactory_rad_s{0.02, 0, 0};

TemperatureReport cell(std::uint8_t bin, std::int16_t centi_c, std::int32_t x,
                       std::uint32_t time_s = 1, std::uint8_t sample = 0) {
    return {.version = 2,
            .bin = bin,
            .sample = sample,
            .actual_centi_c = centi_c,
            .unix_time_s = time_s,
            .gyro_offset = {x, 0, 0}};
}

double units_at(const GyroOffsets& offsets, double temperature_c) {
    return offsets.at(temperature_c).x / kUnit_rad_s;
}

TEST(GyroOffsets, AreTheFactorysWhereNothingIsStored) {
    std::vector<TemperatureReport> empty(35);
    const GyroOffsets offsets(kFactory_rad_s, empty, {});
    EXPECT_EQ(offsets.at(15.0), kFactory_rad_s);
    EXPECT_EQ(offsets.at(45.0), kFactory_rad_s);
    EXPECT_FALSE(offsets.by_temperature());
    EXPECT_EQ(GyroOffsets(kFactory_rad_s).at(30.0), kFactory_rad_s);
}

TEST(GyroOffsets, OneStoredTemperatureGivesNoSlope) {
    const GyroOffsets offsets(kFactory_rad_s, {cell(2, 2500, 40)}, {});
    EXPECT_NEAR(units_at(offsets, 15.0), 40.0, 1e-9);
    EXPECT_NEAR(units_at(offsets, 40.0), 40.0, 1e-9);
    EXPECT_FALSE(offsets.by_temperature());
}

TEST(GyroOffsets, LieOnLinesBetweenTheNewestOfEachBin) {
    // The older sample of the second bin, and a third bin 0.9 degrees beside it, do not count.
    const GyroOffsets offsets(kFactory_rad_s,
                              {cell(4, 3500, 80), cell(2, 2500, 999, 1, 0), cell(2, 2500, 40, 2, 1),
                               cell(3, 2590, 70), cell(0, 1500, 0)},
                              {});
    EXPECT_NEAR(units_at(offsets, 15.0), 0.0, 1e-9);
    EXPECT_NEAR(units_at(offsets, 20.0), 20.0, 1e-9);
    EXPECT_NEAR(units_at(offsets, 25.9), 43.6, 1e-9);
    EXPECT_NEAR(units_at(offsets, 30.0), 60.0, 1e-9);
    // A line is believed for 5 degrees beyond its end.
    EXPECT_NEAR(units_at(offsets, 38.0), 92.0, 1e-9);
    EXPECT_NEAR(units_at(offsets, 60.0), 100.0, 1e-9);
    EXPECT_NEAR(units_at(offsets, -20.0), -20.0, 1e-9);
    EXPECT_TRUE(offsets.by_temperature());
}

TEST(GyroOffsets, WhatTheDeviceFoundSinceHoldsNearItsTemperature) {
    const GyroOffsetReport found{.version = 2, .offset = {50, 0, 0}, .temperature_centi_c = 2500};
    const GyroOffsets offsets(kFactory_rad_s, {cell(0, 1500, 0), cell(4, 3500, 80)}, found);
    EXPECT_NEAR(units_at(offsets, 25.0), 50.0, 1e-9);        // the table says 40
    EXPECT_NEAR(units_at(offsets, 27.5), 50.0 + 5.0, 1e-9);  // half of the 10 is left
    EXPECT_NEAR(units_at(offsets, 30.0), 60.0, 1e-9);
    EXPECT_NEAR(units_at(offsets, 20.0), 20.0, 1e-9);
    GyroOffsetReport none = found;
    none.version = 0;
    EXPECT_NEAR(units_at(GyroOffsets(kFactory_rad_s, {}, none), 25.0), 200.0, 1e-9);
}

TEST(GyroOffsets, AreReadWhereverTheDevicesIndexStands) {
    test::FakeTransport device;
    int next = 17, gets = 0;
    device.answer_by = [&](std::uint8_t id, std::uint16_t) -> Result<std::vector<std::byte>> {
        if (id == GyroOffsetReport::kId) return test::copy_of(GyroOffsetReport{}.encode());
        ++gets;
        const auto bin = static_cast<std::uint8_t>(next / 5);
        const auto sample = static_cast<std::uint8_t>(next % 5);
        next = (next + 1) % 35;
        TemperatureReport report = cell(bin, static_cast<std::int16_t>(1500 + 500 * bin), 10 * bin);
        report.sample = sample;
        if (sample != 3) report.version = 0;
        return test::copy_of(report.encode());
    };
    const auto offsets = read_gyro_offsets(device, kFactory_rad_s);
    ASSERT_TRUE(offsets) << offsets.error().text;
    EXPECT_EQ(gets, 35);
    EXPECT_EQ(offsets->stored().size(), 7U);
    EXPECT_NEAR(units_at(*offsets, 32.5), 35.0, 1e-9);
    device.answer_by = {};
    EXPECT_EQ(read_gyro_offsets(device, kFactory_rad_s).error().code, ErrorCode::unsupported);
}

}  // namespace
}  // namespace foverig::dk2
