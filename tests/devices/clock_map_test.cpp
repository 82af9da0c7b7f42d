#include "devices/clock_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/devices/byte_text.h"

namespace foverig {
namespace {

using test::Random;

constexpr Nanoseconds kMs{1'000'000};

struct Truth {
    double drift = 20e-6;  // device seconds gained per host second
    Nanoseconds offset{5'000'000'000};

    Dk2Time device(HostTime host) const {
        const double host_s = to_seconds(host.time_since_epoch());
        return Dk2Time(host.time_since_epoch() + offset + from_seconds(host_s * drift));
    }
};

/// Feeds `seconds` of packets every `step` with one-sided delays; gives the largest error after
/// `settle_s`.
double worst_error_ms(ClockMap<Dk2Time>& map, const Truth& truth, double seconds, Nanoseconds step,
                      double settle_s, const std::function<Nanoseconds()>& delay) {
    double worst_ms = 0;
    for (HostTime host{}; to_seconds(host.time_since_epoch()) < seconds; host += step) {
        const Dk2Time device = truth.device(host);
        map.update(device, host + delay());
        if (to_seconds(host.time_since_epoch()) < settle_s) continue;
        worst_ms = std::max(worst_ms, std::abs(to_ms(map.to_host(device) - host)));
    }
    return worst_ms;
}

TEST(ClockMap, FollowsDriftThroughPollingJitter) {
    ClockMap<Dk2Time> map;
    Random random(1);
    const double worst_ms =
        worst_error_ms(map, {}, 60, kMs, 1, [&] { return from_seconds(random.uniform() * 1e-3); });
    EXPECT_LT(worst_ms, 0.1);
    EXPECT_NEAR(map.drift(), -20e-6, 5e-6);
    EXPECT_LT(map.residual(), Nanoseconds{50'000});
}

TEST(ClockMap, IgnoresRareLongDelays) {
    ClockMap<Dk2Time> map;
    Random random(2);
    const double worst_ms = worst_error_ms(map, {.drift = -25e-6}, 40, kMs, 2, [&] {
        const double load = random.uniform() < 0.3 ? 20e-3 * random.uniform() : 0;
        return from_seconds(1e-3 * random.uniform() + load);
    });
    EXPECT_LT(worst_ms, 0.3);
    EXPECT_EQ(map.resets(), 0u);
}

TEST(ClockMap, WorksAtTheRateOfAGazeTracker) {
    ClockMap<Dk2Time> map;
    Random random(3);
    const double worst_ms = worst_error_ms(map, {}, 60, Nanoseconds{16'666'667}, 3,
                                           [&] { return from_seconds(1e-3 * random.uniform()); });
    EXPECT_LT(worst_ms, 0.3);
}

TEST(ClockMap, TheConstantPartOfTheDelayStays) {
    ClockMap<Dk2Time> map;
    Random random(4);
    double last_ms = 0;
    for (HostTime host{}; host < HostTime(Nanoseconds{10'000'000'000}); host += kMs) {
        const Dk2Time device = Truth{}.device(host);
        map.update(device, host + kMs + from_seconds(1e-3 * random.uniform()));
        last_ms = to_ms(map.to_host(device) - host);
    }
    EXPECT_NEAR(last_ms, 1.0, 0.05);
}

TEST(ClockMap, IsMonotoneWhileItCorrectsItself) {
    ClockMap<Dk2Time> map;
    Random random(5);
    HostTime before{};
    for (int i = 0; i < 20000; ++i) {
        const HostTime host = HostTime(Nanoseconds{100'000'000'000} + i * kMs);
        // A late start: the first second carries 6 ms more, then the envelope drops.
        const double late_s = i < 1000 ? 6e-3 : 0;
        const Dk2Time device = Truth{}.device(host);
        map.update(device, host + from_seconds(late_s + 1e-3 * random.uniform()));
        for (int k = 3; k >= 0; --k) {
            const HostTime mapped = map.to_host(device - k * Nanoseconds{250'000} + Nanoseconds{1});
            ASSERT_GE(mapped, before) << i;
            before = mapped;
        }
    }
    EXPECT_EQ(map.resets(), 0u);
}

TEST(ClockMap, StartsAgainWhenTheDeviceClockJumpsForward) {
    ClockMap<Dk2Time> map;
    Random random(6);
    const auto delay = [&] { return from_seconds(1e-3 * random.uniform()); };
    for (int i = 0; i < 5000; ++i) {
        const HostTime host{i * kMs};
        map.update(Truth{}.device(host), host + delay());
    }
    const Truth jumped{.offset = Nanoseconds{5'050'000'000}};
    double error_ms = 0;
    for (int i = 5000; i < 8000; ++i) {
        const HostTime host{i * kMs};
        map.update(jumped.device(host), host + delay());
        error_ms = to_ms(map.to_host(jumped.device(host)) - host);
        ASSERT_LT(std::abs(error_ms), 1.1) << i;  // at once: nothing arrives before it is sent
    }
    EXPECT_LT(std::abs(error_ms), 0.1);
    EXPECT_EQ(map.resets(), 1u);
}

TEST(ClockMap, StartsAgainAWindowAfterTheDeviceClockFellBack) {
    ClockMap<Dk2Time> map;
    for (int i = 0; i < 5000; ++i) map.update(Truth{}.device(HostTime{i * kMs}), HostTime{i * kMs});
    const Truth behind{.offset = Nanoseconds{4'950'000'000}};
    for (int i = 5100; i < 7000; ++i)
        map.update(behind.device(HostTime{i * kMs}), HostTime{i * kMs});
    const HostTime host{7000 * kMs};
    EXPECT_LT(std::abs(to_ms(map.to_host(behind.device(host)) - host)), 0.1);
    EXPECT_EQ(map.resets(), 1u);
}

TEST(ClockMap, AStalledHostDoesNotMoveIt) {
    ClockMap<Dk2Time> map;
    for (int i = 0; i < 5000; ++i) {
        const HostTime host{i * kMs};
        // 300 ms without scheduling: the packets of that time are all stamped at its end.
        const HostTime arrival = i >= 3000 && i < 3300 ? HostTime{3300 * kMs} : host;
        map.update(Truth{}.device(host), arrival);
        ASSERT_LT(std::abs(to_ms(map.to_host(Truth{}.device(host)) - host)), 0.1) << i;
    }
    EXPECT_EQ(map.resets(), 0u);
}

TEST(ClockMap, ForgetsOnReset) {
    ClockMap<Dk2Time> map;
    EXPECT_FALSE(map.ready());
    map.update(Dk2Time(kMs), HostTime(kMs));
    EXPECT_TRUE(map.ready());
    map.reset();
    EXPECT_FALSE(map.ready());
    map.update(Dk2Time(500 * kMs), HostTime(2 * kMs));
    EXPECT_EQ(map.to_host(Dk2Time(501 * kMs)), HostTime(3 * kMs));
}

}  // namespace
}  // namespace foverig
