#include "devices/camera/esp570.h"

#include <gtest/gtest.h>

#include "devices/camera/sensor_setup.h"
#include "tests/devices/byte_text.h"
#include "tests/devices/fake_transport.h"

namespace foverig::camera {
namespace {

using test::FakeTransport;

std::vector<std::uint8_t> numbers(Bytes bytes) {
    std::vector<std::uint8_t> out;
    for (const std::byte b : bytes) out.push_back(std::to_integer<std::uint8_t>(b));
    return out;
}
using V = std::vector<std::uint8_t>;

std::vector<std::byte> bytes_of(const V& v) {
    std::vector<std::byte> out;
    for (const std::uint8_t b : v) out.push_back(std::byte{b});
    return out;
}

// DEVICES.md 1.8.1.
TEST(Esp570, AsksInTheBridgesOwnBytes) {
    EXPECT_EQ(numbers(i2c::encode_write(0x98, 0x06, 0x0105)), (V{4, 0x98, 6, 1, 5, 0}));
    EXPECT_EQ(numbers(i2c::encode_read(0x98, 0x00)), (V{0x84, 0x98, 0, 0, 0, 0}));
    const auto eeprom = numbers(eeprom::encode_read(0x2820, 32));
    ASSERT_EQ(eeprom.size(), 59u);
    EXPECT_EQ(V(eeprom.begin(), eeprom.begin() + 6), (V{0x82, 0xA0, 0x28, 0x20, 32, 0}));
}

TEST(Esp570, ReadsAnswersAndRefusesWhatIsNone) {
    EXPECT_EQ(i2c::decode_read(bytes_of({0x84, 0x13, 0x24, 0, 0, 0})).value(), 0x1324);
    EXPECT_FALSE(i2c::decode_read(bytes_of({0x84, 0x13, 0x24, 0, 1, 0})));
    EXPECT_FALSE(i2c::decode_read(bytes_of({0x04, 0x13, 0x24, 0, 0, 0})));
    EXPECT_FALSE(i2c::decode_read(bytes_of({0x84, 0x13, 0x24})));
    const auto asked = i2c::encode_write(0x98, 6, 5);
    EXPECT_TRUE(i2c::decode_write(bytes_of({4, 0x98, 6, 0, 5, 0}), asked));
    EXPECT_FALSE(i2c::decode_write(bytes_of({4, 0x98, 6, 0, 5, 1}), asked));
    EXPECT_FALSE(i2c::decode_write(bytes_of({4, 0x98, 7, 0, 5, 0}), asked));
    EXPECT_EQ(eeprom::decode_read(bytes_of({0x82, 2, 7, 8, 9}), 2).value(), bytes_of({7, 8}));
    EXPECT_FALSE(eeprom::decode_read(bytes_of({0x82, 2, 7}), 2));
    EXPECT_FALSE(eeprom::decode_read(bytes_of({0x82, 3, 7, 8, 9}), 2));
}

/// Answers as the bridge does: with what was set last, a read register filled in.
void answer_like_the_bridge(FakeTransport& transport, std::uint16_t chip_version) {
    transport.answer_by = [&transport, chip_version](
                              std::uint8_t, std::uint16_t) -> Result<std::vector<std::byte>> {
        auto answer = transport.sets.back().data;
        if (answer[0] == std::byte{0x84}) {
            const std::uint16_t value = answer[2] == std::byte{0} ? chip_version : 0x0300;
            answer[1] = static_cast<std::byte>(value >> 8);
            answer[2] = static_cast<std::byte>(value & 0xFF);
        }
        return answer;
    };
}

// DEVICES.md 1.8.2, column "synchronised".
TEST(SensorSetup, TellsTheSensorToFollowTheHeadset) {
    FakeTransport transport;
    answer_like_the_bridge(transport, 0x1324);
    Esp570 bridge(transport);
    ASSERT_TRUE(set_up_sensor(bridge, Sync::headset));
    std::map<std::uint8_t, V> written;  // high and low byte of each write, by register
    for (const auto& call : transport.sets) {
        EXPECT_EQ(call.id, 2);
        EXPECT_EQ(call.value, 4);
        const V b = numbers(call.data);
        if (b[0] == 4 && b[1] == 0x98) written[b[2]].insert(written[b[2]].end(), {b[3], b[4]});
    }
    EXPECT_EQ(written[0x0D], (V{0x03, 0x30}));
    EXPECT_EQ(written[0xAF], (V{0, 0}));
    EXPECT_EQ(written[0x48], (V{0, 0x81}));
    EXPECT_EQ(written[0x35], (V{0, 16}));
    EXPECT_EQ(written[0x06], (V{0, 5}));
    EXPECT_EQ(written[0x05], (V{0, 94}));
    EXPECT_EQ(written[0x0B], (V{0, 11}));
    EXPECT_EQ(written[0xD5], (V{0, 111}));
    EXPECT_EQ(written[0x07], (V{0x01, 0x88, 0x01, 0x98}));
    EXPECT_EQ(written[0x1B], (V{0, 2}));
    const V light = numbers(transport.sets.back().data);
    EXPECT_EQ(V(light.begin(), light.begin() + 5), (V{4, 0x60, 6, 0, 0x20}));
}

TEST(SensorSetup, LeavesAnotherSensorAlone) {
    FakeTransport transport;
    answer_like_the_bridge(transport, 0x1313);
    Esp570 bridge(transport);
    const Status status = set_up_sensor(bridge, Sync::headset);
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, ErrorCode::unsupported);
    EXPECT_EQ(transport.sets.size(), 1u);
}

TEST(Esp570, SaysWhatTheTransportSaid) {
    FakeTransport transport;
    transport.refuse_sets = true;
    Esp570 bridge(transport);
    EXPECT_EQ(bridge.read_register(0x98, 0).error().text, "refused by the test");
    EXPECT_FALSE(bridge.read_eeprom(0x2000, 122));
    EXPECT_FALSE(bridge.greet());
}

}  // namespace
}  // namespace foverig::camera
