#include "devices/dk2/decoder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/devices/byte_text.h"

namespace foverig::dk2 {
namespace {

InputReport11 report(std::uint16_t count, std::uint8_t samples, std::uint32_t stamp_us) {
    InputReport11 r;
    r.sample_count = count;
    r.num_samples = samples;
    r.sample_timestamp_us = stamp_us;
    r.slots[0] = {{0, 98000, 0}, {100, 0, 0}};
    r.slots[1] = {{0, 98100, 0}, {200, 0, 0}};
    r.temperature_centi_c = 3125;
    return r;
}

DecodedReport decoded(Dk2Decoder& decoder, const InputReport11& r) {
    const auto out = decoder.decode(r.encode());
    EXPECT_TRUE(out) << (out ? "" : out.error().text);
    return out ? *out : DecodedReport{};
}

std::int64_t us(Dk2Time t) {
    return t.time_since_epoch().count() / 1000;
}

TEST(Dk2Decoder, OneSampleIsSlotZero) {
    Dk2Decoder decoder;
    const auto out = decoded(decoder, report(10, 1, 5000));
    ASSERT_EQ(out.samples.size(), 1u);
    EXPECT_DOUBLE_EQ(out.samples[0].gyro_rad_s.x, 0.01);
    EXPECT_DOUBLE_EQ(out.samples[0].accel_m_s2.y, 9.8);
    EXPECT_DOUBLE_EQ(out.samples[0].temperature_c, 31.25);
    EXPECT_EQ(us(out.samples[0].device_time), 5000);
}

TEST(Dk2Decoder, TwoSamplesAreAMillisecondApart) {
    Dk2Decoder decoder;
    const auto out = decoded(decoder, report(10, 2, 5000));
    ASSERT_EQ(out.samples.size(), 2u);
    EXPECT_EQ(us(out.samples[0].device_time), 4000);
    EXPECT_EQ(us(out.samples[1].device_time), 5000);
    EXPECT_DOUBLE_EQ(out.samples[0].gyro_rad_s.x, 0.01);
    EXPECT_DOUBLE_EQ(out.samples[1].gyro_rad_s.x, 0.02);
    EXPECT_EQ(out.samples[1].sequence, out.samples[0].sequence + 1);
}

TEST(Dk2Decoder, TheMeanStandsForAllButTheNewest) {
    for (const int n : {3, 4, 254}) {
        Dk2Decoder fresh;
        const auto out = decoded(fresh, report(0, static_cast<std::uint8_t>(n), 1'000'000));
        ASSERT_EQ(out.samples.size(), static_cast<std::size_t>(n));
        for (int k = 0; k < n; ++k) {
            const ImuSample& s = out.samples[static_cast<std::size_t>(k)];
            EXPECT_EQ(us(s.device_time), 1'000'000 - (n - 1 - k) * 1000);
            EXPECT_DOUBLE_EQ(s.gyro_rad_s.x, k == n - 1 ? 0.02 : 0.01);
            EXPECT_EQ(s.sequence % 65536, static_cast<std::uint64_t>(k));
        }
    }
}

TEST(Dk2Decoder, CountsLossAcrossTheCountersWrap) {
    Dk2Decoder decoder;
    EXPECT_EQ(decoded(decoder, report(65534, 2, 1000)).lost, 0);
    EXPECT_EQ(decoded(decoder, report(0, 2, 3000)).lost, 0);
    const auto out = decoded(decoder, report(7, 1, 9000));
    EXPECT_EQ(out.lost, 5);
    EXPECT_TRUE(out.samples.front().gap);
    const auto next = decoded(decoder, report(8, 2, 11000));
    EXPECT_EQ(next.lost, 0);
    EXPECT_FALSE(next.samples.front().gap);
    EXPECT_EQ(next.samples.front().sequence, out.samples.front().sequence + 1);
}

TEST(Dk2Decoder, RefusesAndCountsReportsOutOfOrder) {
    Dk2Decoder decoder;
    decoded(decoder, report(0, 1, 1000));
    decoded(decoder, report(1, 1, 2000));
    EXPECT_FALSE(decoder.decode(report(0, 1, 1000).encode()));
    EXPECT_FALSE(decoder.decode(report(1, 1, 2000).encode()));
    EXPECT_EQ(decoder.backwards(), 1u);
    EXPECT_EQ(decoder.duplicates(), 1u);
    EXPECT_EQ(decoded(decoder, report(2, 1, 3000)).lost, 0);
}

TEST(Dk2Decoder, FrameStampMayLieBeforeTheWrapOfTheSampleStamp) {
    Dk2Decoder decoder;
    decoded(decoder, report(0, 1, 0xFFFFFF00u));
    InputReport11 r = report(1, 1, 0x00000200u);
    r.frame_count = 77;
    r.frame_id = 144;
    r.frame_timestamp_us = 0xFFFFE000u;
    const auto out = decoded(decoder, r);
    EXPECT_EQ(out.samples[0].device_time - out.panel.vsync_device,
              Nanoseconds((0x200 + 0x2000) * 1000));
    EXPECT_EQ(out.panel.frame_count, 77);
    EXPECT_EQ(out.panel.grey, 144);
}

TEST(Dk2Decoder, Report1ContinuesTheTimeByCount) {
    Dk2Decoder decoder;
    InputReport1 old;
    old.sample_count = 12;
    old.num_samples = 3;
    for (std::size_t i = 0; i < 3; ++i)
        old.slots[i].gyro = {static_cast<std::int32_t>(100 * i), 0, 0};
    EXPECT_FALSE(decoder.decode(old.encode()));  // no time base yet
    decoded(decoder, report(10, 1, 5000));
    const auto out = decoder.decode(old.encode());
    ASSERT_TRUE(out);
    EXPECT_TRUE(out->is_report1);
    EXPECT_EQ(out->lost, 1);
    ASSERT_EQ(out->samples.size(), 3u);
    EXPECT_EQ(us(out->samples[2].device_time), 9000);
    EXPECT_DOUBLE_EQ(out->samples[1].gyro_rad_s.x, 0.01);
    EXPECT_EQ(decoded(decoder, report(15, 1, 10050)).lost, 0);
}

TEST(Dk2Decoder, RefusesAReport1ThatCameBeforeInsteadOfLosingAMinute) {
    Dk2Decoder decoder;
    decoded(decoder, report(10, 1, 5000));
    InputReport1 old;
    old.sample_count = 11;
    old.num_samples = 3;
    ASSERT_TRUE(decoder.decode(old.encode()));
    EXPECT_FALSE(decoder.decode(old.encode()));  // again
    old.sample_count = 5;
    EXPECT_FALSE(decoder.decode(old.encode()));  // older
    EXPECT_EQ(decoder.backwards(), 2u);
    old.sample_count = 14;
    const auto next = decoder.decode(old.encode());
    ASSERT_TRUE(next);
    EXPECT_EQ(next->lost, 0);
    EXPECT_EQ(us(next->samples.back().device_time), 11000);
}

TEST(Dk2Decoder, AppliesTheFactoryCalibration) {
    FactoryCalibration calibration;
    calibration.gyro_offsets = GyroOffsets({0.005, 0, 0});
    calibration.gyro_from_raw[0] = dvec3(2, 0, 1);
    Dk2Decoder decoder(calibration);
    const auto out = decoded(decoder, report(0, 1, 1000));
    EXPECT_NEAR(out.samples[0].gyro_rad_s.x, 0.010, 1e-12);
    EXPECT_NEAR(out.samples[0].gyro_rad_s.z, 0.005, 1e-12);
}

TEST(Dk2Decoder, TakesTheOffsetOfTheChipsTemperature) {
    FactoryCalibration calibration;
    calibration.gyro_offsets =
        GyroOffsets(dvec3(0),
                    {{.version = 1, .bin = 0, .actual_centi_c = 2000, .gyro_offset = {10, 0, 0}},
                     {.version = 1, .bin = 2, .actual_centi_c = 3000, .gyro_offset = {30, 0, 0}}},
                    {});
    Dk2Decoder decoder(calibration);
    InputReport11 r = report(0, 1, 1000);
    const double raw_rad_s = to_si(r.slots[0].gyro).x;
    r.temperature_centi_c = 2750;
    EXPECT_NEAR(decoded(decoder, r).samples[0].gyro_rad_s.x, raw_rad_s - 25e-4, 1e-12);
}

TEST(Dk2Decoder, SurvivesRandomPacketsOfBothFormats) {
    test::Random random(5);
    Dk2Decoder decoder;
    std::size_t samples = 0;
    for (int i = 0; i < 20000; ++i) {
        std::vector<std::byte> bytes =
            random.bytes(i % 3 == 0 ? random.bits() % 70 : (i % 3 == 1 ? 64 : 62));
        if (i % 3 == 1) bytes[0] = std::byte{11};
        if (i % 3 == 2) bytes[0] = std::byte{1};
        const auto out = decoder.decode(bytes);
        if (!out) continue;
        samples += out->samples.size();
        for (const ImuSample& s : out->samples) {
            ASSERT_TRUE(std::isfinite(s.gyro_rad_s.x) && std::isfinite(s.accel_m_s2.y));
        }
    }
    EXPECT_GT(samples, 10000u);
}

}  // namespace
}  // namespace foverig::dk2
