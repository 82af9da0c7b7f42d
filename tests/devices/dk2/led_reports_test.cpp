#include "devices/dk2/led_reports.h"

#include <gtest/gtest.h>

#include "devices/dk2/leds.h"
#include "tests/devices/fake_transport.h"

namespace foverig::dk2 {
namespace {

TEST(LedReports, FieldsLieWhereTheFirmwareHasThem) {
    const PositionReport position{.command_id = 0x0102,
                                  .version = 2,
                                  .position_um = {-27362, -48634, 67100},
                                  .normal = {-54, -1198, 36},
                                  .rotation_1e4_rad = -7,
                                  .index = 5,
                                  .count = 41,
                                  .kind = PositionReport::Kind::imu};
    const auto b = position.encode();
    EXPECT_EQ(read_u8(b, 0), 15);
    EXPECT_EQ(static_cast<std::int32_t>(read_u32(b, 4)), -27362);
    EXPECT_EQ(static_cast<std::int32_t>(read_u32(b, 12)), 67100);
    EXPECT_EQ(read_s16(b, 18), -1198);
    EXPECT_EQ(read_u16(b, 24), 5);
    EXPECT_EQ(read_u16(b, 26), 41);
    EXPECT_EQ(read_u16(b, 28), 1);
    EXPECT_EQ(PositionReport::decode(b).value(), position);
    EXPECT_FALSE(PositionReport::decode(Bytes(b).first(22)));
}

// Every default pattern is dim at least: p & ~0xAAAAA is 0x55555 (DEVICES.md 1.5).
TEST(LedReports, CodesAreTheOddBitsOfTheSequence) {
    for (const auto code : std::array<std::uint16_t, 4>{0x001, 0x01a, 0x2e3, 0x1fc}) {
        const std::uint32_t sequence = PatternReport::sequence_of(code);
        EXPECT_EQ(sequence & ~0xAAAAAu, 0x55555u);
        const PatternReport report{.sequence = sequence, .index = 3};
        EXPECT_EQ(report.code(), code);
        EXPECT_EQ(PatternReport::decode(report.encode()).value(), report);
    }
}

TEST(Leds, ATableThatDoesNotCountThroughIsRefused) {
    for (const std::uint16_t count : {std::uint16_t{0}, std::uint16_t{5}, std::uint16_t{65535}}) {
        test::FakeTransport transport;
        transport.answer_by = [count](std::uint8_t, std::uint16_t) {
            return Result<std::vector<std::byte>>(
                to_vector(PositionReport{.index = 2, .count = count}.encode()));
        };
        const auto leds = read_leds(transport);
        ASSERT_FALSE(leds) << count;
        EXPECT_EQ(leds.error().code, ErrorCode::invalid_data);
    }
}

}  // namespace
}  // namespace foverig::dk2
