#include "devices/camera/exposure_pairing.h"

#include <gtest/gtest.h>

namespace foverig::camera {
namespace {

constexpr std::int64_t kInterval_us = 16666;

HostTime at_us(std::int64_t us) {
    return HostTime(std::chrono::microseconds(us));
}
dk2::LedExposure flash(int number) {
    return {.count = static_cast<std::uint16_t>(number),
            .pattern = static_cast<std::uint8_t>(number % 10),
            .start_device = Dk2Time(std::chrono::microseconds(5'000'000 + number * kInterval_us)),
            .start = at_us(number * kInterval_us)};
}

TEST(ExposurePairing, AFrameShowsTheFlashBeforeIt) {
    ExposurePairing pairing(std::chrono::microseconds(350));
    for (int i = 1; i <= 5; ++i) pairing.add(flash(i));
    for (int i = 1; i <= 5; ++i) {
        const auto shown = pairing.of(at_us(i * kInterval_us + 650));
        ASSERT_TRUE(shown);
        EXPECT_EQ(shown->pattern, i % 10);
        EXPECT_EQ(shown->middle, at_us(i * kInterval_us + 175));
        EXPECT_EQ(shown->middle_device.time_since_epoch(),
                  std::chrono::microseconds(5'000'000 + i * kInterval_us + 175));
    }
    EXPECT_FALSE(pairing.of(at_us(5 * kInterval_us + 700)));
}

TEST(ExposurePairing, LostFramesAndLateHostsShiftNothing) {
    ExposurePairing pairing(std::chrono::microseconds(350));
    for (int i = 1; i <= 40; ++i) {
        pairing.add(flash(i));
        if (i % 3 == 0) continue;
        const auto shown = pairing.of(at_us(i * kInterval_us + 300 + 97 * i));
        ASSERT_TRUE(shown) << i;
        EXPECT_EQ(shown->pattern, i % 10);
        EXPECT_EQ(shown->number, i - 1);
    }
}

// The headset was silent: what it said last belongs to an older frame.
TEST(ExposurePairing, AnOldFlashIsNotTaken) {
    ExposurePairing pairing(std::chrono::microseconds(350));
    pairing.add(flash(1));
    EXPECT_FALSE(pairing.of(at_us(2 * kInterval_us + 650)));
}

TEST(ExposurePairing, CountsOnAcrossTheWrap) {
    ExposurePairing pairing(std::chrono::microseconds(350));
    pairing.add(flash(65534));
    pairing.add(flash(65539));
    EXPECT_EQ(pairing.of(at_us(65539 * kInterval_us + 500))->number, 5);
}

}  // namespace
}  // namespace foverig::camera
