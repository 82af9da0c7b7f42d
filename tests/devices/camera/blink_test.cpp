// Blink codes of the firmware's own table (simulators/dk2/led_table.h is not seen here: the codes
// are DEVICES.md 1.8.5's, typed again as what a device answers).
#include <gtest/gtest.h>

#include <cmath>

#include "devices/camera/blob_tracks.h"

namespace foverig::camera {
namespace {

constexpr std::array<std::uint16_t, 40> kCodes{
    0x001, 0x006, 0x01a, 0x01d, 0x028, 0x02f, 0x033, 0x04b, 0x04c, 0x057,
    0x062, 0x065, 0x079, 0x07e, 0x090, 0x0a4, 0x114, 0x151, 0x183, 0x18c,
    0x199, 0x1aa, 0x1b5, 0x1c0, 0x1cf, 0x1d6, 0x1e9, 0x1f3, 0x1fc, 0x230,
    0x252, 0x282, 0x285, 0x29b, 0x29c, 0x2ae, 0x2b7, 0x2c8, 0x2d1, 0x2e3};

std::vector<dk2::Led> all_leds() {
    std::vector<dk2::Led> leds;
    for (const std::uint16_t code : kCodes) leds.push_back({.code = code});
    return leds;
}

/// Twelve frames of one LED; the newest is number 11.
BlinkHistory blinking(std::uint16_t code, double ratio, double growth_a_frame,
                      std::uint16_t wrong_bits = 0) {
    BlinkHistory history;
    for (int frame = 0; frame < 12; ++frame) {
        const auto phase = static_cast<std::size_t>(frame % 10);
        const bool bright = (((code ^ wrong_bits) >> phase) & 1) != 0;
        history.seen[phase] = {std::log((bright ? ratio : 1.0) * 1000.0) + growth_a_frame * frame,
                               frame};
    }
    return history;
}

TEST(BlinkCode, EveryLedIsKnownAtAnyRatioThatIsAnEdge) {
    const auto leds = all_leds();
    for (std::size_t i = 0; i < leds.size(); ++i) {
        for (const double ratio : {1.15, 1.5, 2.0, 4.0}) {
            const auto code = code_of(blinking(kCodes[i], ratio, 0.0), 11);
            ASSERT_TRUE(code) << i << " " << ratio;
            EXPECT_EQ(led_of(*code, leds), i) << ratio;
        }
    }
}

// 2 % a frame is a head that comes a metre nearer each second.
TEST(BlinkCode, AHeadThatComesNearerIsNoBlinking) {
    const auto leds = all_leds();
    for (std::size_t i = 0; i < leds.size(); ++i) {
        for (const double growth : {-0.02, 0.02}) {
            const auto code = code_of(blinking(kCodes[i], 2.0, growth), 11);
            ASSERT_TRUE(code);
            EXPECT_EQ(led_of(*code, leds), i) << growth;
        }
    }
}

TEST(BlinkCode, OneWrongBitIsMendedAndTwoAreNeverGuessed) {
    const auto leds = all_leds();
    for (std::size_t i = 0; i < leds.size(); ++i) {
        for (int a = 0; a < 10; ++a) {
            EXPECT_EQ(led_of(static_cast<std::uint16_t>(kCodes[i] ^ 1 << a), leds), i);
            for (int b = 0; b < a; ++b) {
                EXPECT_NE(led_of(static_cast<std::uint16_t>(kCodes[i] ^ 1 << a ^ 1 << b), leds), i);
            }
        }
    }
}

TEST(BlinkCode, NothingIsReadFromSteadyLightOrHalfACycle) {
    EXPECT_FALSE(code_of(blinking(0x01a, 1.05, 0.0), 11));
    EXPECT_FALSE(code_of(blinking(0x000, 2.0, 0.0), 11));
    BlinkHistory half = blinking(0x01a, 2.0, 0.0);
    half.seen[3] = {};
    EXPECT_FALSE(code_of(half, 11));
    EXPECT_FALSE(code_of(blinking(0x01a, 2.0, 0.0), 40));
}

TEST(BlobTracks, TwoSpotsThatPassEachOtherKeepTheirNames) {
    const std::vector<dk2::Led> leds{{.code = 0x01a}, {.code = 0x1c0}};
    BlobTracks tracks(leds);
    std::vector<TrackedBlob> seen;
    for (int frame = 0; frame < 40; ++frame) {
        const auto light = [&](std::size_t led) {
            return (leds[led].code >> frame % 10 & 1) != 0 ? 2000.0 : 1000.0;
        };
        const std::array blobs{
            Blob{.center_px = {100.0 + 3.0 * frame, 50}, .brightness = light(0)},
            Blob{.center_px = {200.0 - 3.0 * frame, 62}, .brightness = light(1)}};
        seen = tracks.follow(blobs, frame, static_cast<std::uint8_t>(frame % 10));
        if (frame == 15) {
            EXPECT_EQ(seen[0].led, 0u);
            EXPECT_EQ(seen[1].led, 1u);
        }
    }
    EXPECT_EQ(seen[0].led, 0u);
    EXPECT_EQ(seen[1].led, 1u);
}

}  // namespace
}  // namespace foverig::camera
