#include "devices/camera/tracker_camera.h"

#include <gtest/gtest.h>

#include "tests/devices/fake_transport.h"

namespace foverig::camera {
namespace {

using test::FakeTransport;

/// Answers as the bridge does (DEVICES.md 1.8.1), with an empty calibration memory; but for one
/// selector that it does not have.
void answer_without(FakeTransport& transport, std::uint8_t lacking) {
    transport.answer_by = [&transport, lacking](std::uint8_t selector,
                                                std::uint16_t) -> Result<std::vector<std::byte>> {
        if (selector == lacking) return Error{ErrorCode::unsupported, "no such selector"};
        auto answer = transport.sets.back().data;
        const bool chip_version = answer[0] == std::byte{0x84} && answer[2] == std::byte{0};
        if (chip_version) {
            answer[1] = std::byte{0x13};
            answer[2] = std::byte{0x24};
        } else if (answer[0] == std::byte{0x82}) {
            answer[1] = answer[4];
        }
        return answer;
    };
}

TEST(TrackerCamera, IsSetUpWhereItWillNotBeGreeted) {
    FakeTransport transport;
    answer_without(transport, 3);
    const auto camera = TrackerCamera::open(transport, Sync::headset);
    ASSERT_TRUE(camera) << camera.error().text;
    EXPECT_FALSE(camera->as_it_is());
    EXPECT_FALSE(camera->calibrated()) << "the memory is empty";
    EXPECT_GT(transport.sets_of(i2c::kSelector), 10);
    EXPECT_GT(transport.sets_of(eeprom::kSelector), 0);
}

TEST(TrackerCamera, SaysWhyItIsTakenAsItIs) {
    FakeTransport transport;
    answer_without(transport, i2c::kSelector);
    const auto camera = TrackerCamera::open(transport, Sync::headset);
    ASSERT_TRUE(camera) << camera.error().text;
    ASSERT_TRUE(camera->as_it_is());
    EXPECT_EQ(camera->as_it_is()->text, "no such selector");
}

}  // namespace
}  // namespace foverig::camera
