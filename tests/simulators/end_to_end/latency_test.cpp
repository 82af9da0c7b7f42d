// Motion to scan-out measured through the panel's read-back, against what the simulators know.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "devices/display/latency_tester.h"
#include "devices/dk2/imu_source.h"
#include "simulators/dk2/simulated_dk2.h"
#include "simulators/motion/simple_heads.h"
#include "simulators/panel/virtual_panel.h"

namespace foverig {
namespace {

using std::chrono::milliseconds;

struct Outcome {
    int frames = 0, readings = 0;
    double worst_motion_error_ms = 0;
};

/// Frames of 6 ms; with `some_late`, each tenth takes 15 ms and misses its vsync.
Outcome outcome_of(const PanelFaults& faults, bool some_late) {
    ManualClock clock;
    const motion::StillHead still;
    VirtualPanel panel({.faults = faults, .seed = 2});
    SimulatedDk2 device(clock, still, {.panel = &panel});
    auto source = std::move(dk2::Dk2ImuSource::open(device, clock.now())).value();
    LatencyTester tester;
    struct Known {
        HostTime imu, scan_out;
    };
    std::map<std::uint64_t, Known> known;
    Outcome outcome;
    HostTime newest{};
    for (std::uint64_t id = 1; id < 1500; ++id) {
        clock.sleep_until(panel.next_vsync(clock.now() + Nanoseconds(1)));
        while (true) {
            auto next = source.next(clock.now());
            const auto* sample = std::get_if<ImuSample>(&next);
            if (sample == nullptr) break;
            newest = sample->host_time;
        }
        for (const dk2::PanelReadback& read : source.take_panel_readbacks()) {
            for (const LatencyReading& r :
                 tester.read_back(read.frame_count, read.vsync, read.grey)) {
                const Known truth = known.at(r.frame_id);
                const Nanoseconds motion = truth.scan_out - truth.imu;
                outcome.worst_motion_error_ms = std::max(
                    outcome.worst_motion_error_ms, std::abs(to_ms(r.motion_to_scan_out - motion)));
                ++outcome.readings;
            }
        }
        const HostTime predicted = panel.next_vsync(clock.now() + Nanoseconds(1));
        const HostTime submit = clock.now() + milliseconds(some_late && id % 10 == 0 ? 15 : 6);
        const std::uint8_t grey = tester.mark({id, newest, submit, predicted});
        clock.sleep_until(submit);
        const Presentation shown = panel.present({.frame_id = id, .latency_level = grey}, submit);
        known[id] = {newest, shown.vsync};
        ++outcome.frames;
    }
    return outcome;
}

TEST(LatencyEndToEnd, EveryFrameIsReadBackWithItsLatency) {
    const Outcome outcome = outcome_of({}, true);
    EXPECT_GT(outcome.readings, 0.95 * outcome.frames);
    EXPECT_LT(outcome.worst_motion_error_ms, 0.15);  // the clock map's 0.1 ms of poll phase
}

TEST(LatencyEndToEnd, LostReadsCostReadingsAndGiveNoWrongOnes) {
    for (const bool some_late : {false, true}) {
        const Outcome outcome = outcome_of({.lost_readback = 0.05}, some_late);
        EXPECT_GT(outcome.readings, 0.8 * outcome.frames);
        EXPECT_LT(outcome.worst_motion_error_ms, 0.15);
    }
}

}  // namespace
}  // namespace foverig
