#include "devices/time.h"

#include <gtest/gtest.h>

namespace foverig {
namespace {

TEST(WallClock, GoesAtItsSpeedAndSleepsByItsOwnTime) {
    const WallClock real;
    WallClock fast(1000.0);
    fast.sleep_until(HostTime(Nanoseconds(5'000'000'000)));
    EXPECT_GE(fast.now(), HostTime(Nanoseconds(5'000'000'000)));
    EXPECT_GE(real.now(), HostTime(Nanoseconds(5'000'000))) << "5 s at 1000 times the speed";
    const HostTime before = fast.now();
    EXPECT_GE(fast.now(), before);
}

}  // namespace
}  // namespace foverig
