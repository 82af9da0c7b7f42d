#include "devices/gaze/requests.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "devices/crc32.h"
#include "tests/devices/byte_text.h"

namespace foverig::gaze {
namespace {

using test::bytes_of;
using test::copy_of;

TEST(GazeInfo, LaysFieldsOutByTheTable) {
    const Info info{.rates = 0b101,
                    .capabilities = 0x13,
                    .serial = "0123456789ABCDEF",
                    .firmware = "sim 1",
                    .nominal_latency_us = 12000};
    const auto b = info.encode();
    EXPECT_EQ(copy_of(Bytes(b).first(16)),
              bytes_of("53 47 5a 31 01 00 05 00 13 00 00 00 30 31 32 33"));
    EXPECT_EQ(read_u16(b, 44), 1920);
    EXPECT_EQ(read_u32(b, 48), 1000000000u);
    EXPECT_EQ(read_u32(b, 52), 12000u);
    const auto back = Info::decode(b);
    ASSERT_TRUE(back);
    EXPECT_EQ(*back, info);
}

TEST(DeviceStatus, LaysFieldsOutByTheTable) {
    const DeviceStatus status{.state = DeviceState::streaming,
                              .session = 0x01020304,
                              .sent = 7,
                              .dropped = 8,
                              .calibration_id = 9,
                              .calibration_points = 5,
                              .calibration_quality = 90,
                              .options = 3};
    EXPECT_EQ(
        copy_of(Bytes(status.encode()).first(28)),
        bytes_of(
            "01 00 58 02 04 03 02 01 07 00 00 00 08 00 00 00 09 00 05 5a 00 80 bb 44 03 00 00 00"));
    EXPECT_EQ(*DeviceStatus::decode(status.encode()), status);
}

TEST(DeviceTimeReply, CarriesTheCookie) {
    const DeviceTimeReply reply{.device_ns = 1'000'012'000'000, .cookie = 0x0201};
    EXPECT_EQ(copy_of(Bytes(reply.encode()).first(12)),
              bytes_of("00 2b 5c d5 e8 00 00 00 01 02 00 00"));
    EXPECT_EQ(*DeviceTimeReply::decode(reply.encode()), reply);
}

template <class Payload>
void expect_sealed(const Payload& payload) {
    const auto good = copy_of(payload.encode());
    for (std::size_t n = 0; n < good.size(); ++n)
        EXPECT_FALSE(Payload::decode(Bytes(good).first(n))) << n;
    for (std::size_t i = 0; i < good.size(); ++i) {
        auto bad = good;
        bad[i] ^= std::byte{0x10};
        EXPECT_FALSE(Payload::decode(bad)) << i;
    }
}

TEST(GazePayloads, RejectTruncationAndDamage) {
    expect_sealed(Info{.serial = "a", .firmware = "b"});
    expect_sealed(DeviceStatus{});
    expect_sealed(DeviceTimeReply{.device_ns = 5});
}

TEST(CalibrationBlob, LiesAsTheTableSays) {
    const CalibrationBlob blob{.id = 0x0203, .data = {std::byte{7}, std::byte{8}}};
    const auto b = blob.encode();
    EXPECT_EQ(copy_of(Bytes(b).first(12)), bytes_of("53 47 5a 43 02 00 03 02 07 08 00 00"));
    EXPECT_EQ(read_u32(b, 508), crc32(Bytes(b).first(508)));
    EXPECT_EQ(*CalibrationBlob::decode(b), blob);
    expect_sealed(blob);
    auto too_long = b;
    write_u16(too_long, 4, 501);
    write_u32(too_long, 508, crc32(Bytes(too_long).first(508)));
    EXPECT_FALSE(CalibrationBlob::decode(too_long));
}

TEST(SetMapping, InfinityMeansVergenceAndNonsenseIsRefused) {
    EXPECT_TRUE(
        std::isinf(*decode_mapping(encode_mapping(std::numeric_limits<float>::infinity()))));
    EXPECT_FALSE(decode_mapping(encode_mapping(0)));
    EXPECT_FALSE(decode_mapping(encode_mapping(std::nanf(""))));
    EXPECT_FALSE(decode_mapping({}));
}

TEST(SetOptions, IsOneWord) {
    EXPECT_EQ(copy_of(encode_options(option::events | option::binocular_low_pass)),
              bytes_of("06 00 00 00"));
    EXPECT_EQ(*decode_options(encode_options(6)), 6u);
    EXPECT_FALSE(decode_options(bytes_of("06 00 00")));
}

TEST(CalibrationTargets, ArePairs) {
    const Vec2f targets[] = {{480, 540}, {96, 216}};
    const auto b = encode_targets(targets);
    EXPECT_EQ(b.size(), 16u);
    EXPECT_EQ((*decode_targets(b))[1], targets[1]);
    EXPECT_FALSE(decode_targets(Bytes(b).first(12)));
    EXPECT_TRUE(decode_targets({})->empty());
}

TEST(SimFault, RoundTrips) {
    const SimFault fault{
        .kind = FaultKind::clock_drift, .count = 2, .p1 = 1.5f, .p2 = -1, .duration_ms = 100};
    EXPECT_EQ(copy_of(fault.encode()), bytes_of("09 00 02 00 00 00 c0 3f 00 00 80 bf 64 00 00 00"));
    EXPECT_EQ(*SimFault::decode(fault.encode()), fault);
    EXPECT_FALSE(SimFault::decode(bytes_of("09 00")));
}

}  // namespace
}  // namespace foverig::gaze
