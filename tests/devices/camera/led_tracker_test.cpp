#include "devices/camera/led_tracker.h"

#include <gtest/gtest.h>

namespace foverig::camera {
namespace {

constexpr int kWidth = 752, kHeight = 480;

/// Squares of light, `apart_px` from one to the next.
std::vector<std::byte> strewn(int apart_px) {
    std::vector<std::byte> bytes(kWidth * kHeight, std::byte{10});
    for (int y = 4; y + 4 < kHeight; y += apart_px) {
        for (int x = 4; x + 4 < kWidth; x += apart_px) {
            for (const int at : {y * kWidth + x, (y + 1) * kWidth + x}) {
                bytes[static_cast<std::size_t>(at)] = std::byte{200};
                bytes[static_cast<std::size_t>(at + 1)] = std::byte{200};
            }
        }
    }
    return bytes;
}

TEST(LedTracker, DoesNotSearchAnImageThatIsFullOfSpots) {
    LedTracker tracker({}, Lens{});
    const auto few = strewn(60), many = strewn(6);
    EXPECT_FALSE(tracker.see({kWidth, kHeight, kWidth, few}, 0, 0, std::nullopt));
    EXPECT_EQ(tracker.spots().size(), 13u * 8u);
    EXPECT_EQ(tracker.counts().crowded, 0u);
    EXPECT_FALSE(tracker.see({kWidth, kHeight, kWidth, many}, 1, 1, std::nullopt));
    EXPECT_TRUE(tracker.spots().empty());
    EXPECT_EQ(tracker.counts().crowded, 1u);
    EXPECT_EQ(find_blobs({kWidth, kHeight, kWidth, many}).size(), 201u);
}

}  // namespace
}  // namespace foverig::camera
