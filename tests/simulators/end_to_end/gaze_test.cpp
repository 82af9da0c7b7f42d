// From the eyes' motion through the tracker's bytes, the decoder, the clock map and the filter,
// against the motion itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "devices/gaze/gaze_filter.h"
#include "devices/gaze/gaze_source.h"
#include "simulators/gaze/simulated_gaze.h"
#include "simulators/motion/catalog.h"

namespace foverig {
namespace {

double angle_deg(const dvec3& a, const dvec3& b) {
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

struct Outcome {
    std::vector<double> sample_error_deg;  ///< against the truth at each sample's own host time
    std::vector<double> photon_error_deg;  ///< of the filtered gaze against the truth at the photon
    double worst_time_error_us = 0;
    int invalid = 0;
    SourceCounts counts;
    std::uint64_t missed_exposures = 0;
};

struct Run {
    const char* motion = "scan";
    GazeFaults faults{};
    std::uint16_t rate_hz = 60;
    int seconds = 30;
};

double quantile(std::vector<double> values, double p) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(p * static_cast<double>(values.size() - 1))];
}

Outcome outcome_of(const Run& run) {
    ManualClock clock;
    const auto eyes = std::move(motion::make_eye(run.motion, 8)).value();
    SimulatedGaze device(clock, *eyes, {.faults = run.faults, .seed = 8});
    auto opened = gaze::GazeSource::open(device, clock, {.rate_hz = run.rate_hz});
    EXPECT_TRUE(opened);
    gaze::GazeSource source = std::move(opened).value();
    GazeFilter filter;
    const auto truth = [&](HostTime t) {
        return eyes->at(to_seconds(t.time_since_epoch())).direction;
    };

    Outcome outcome;
    for (int frame = 1; frame < 75 * run.seconds; ++frame) {
        clock.sleep_until(HostTime(from_seconds(frame / 75.0)));
        while (true) {
            auto next = source.next(clock.now());
            const auto* sample = std::get_if<GazeSample>(&next);
            if (sample == nullptr) break;
            filter.add(*sample);
            const HostTime exposed(
                from_seconds(static_cast<double>(sample->camera_frame) / run.rate_hz));
            outcome.worst_time_error_us =
                std::max(outcome.worst_time_error_us,
                         1e6 * std::abs(to_seconds(sample->host_time - exposed)));
            if (!sample->valid) {
                ++outcome.invalid;
                continue;
            }
            outcome.sample_error_deg.push_back(
                angle_deg(sample->combined.direction, truth(exposed)));
        }
        const HostTime photon = clock.now() + std::chrono::milliseconds(20);
        const FilteredGaze gaze = filter.at(photon);
        if (gaze.combined.usable) {
            outcome.photon_error_deg.push_back(angle_deg(gaze.combined.direction, truth(photon)));
        }
    }
    outcome.counts = source.counts();
    outcome.missed_exposures = source.missed_exposures();
    return outcome;
}

GazeFaults typical(std::string_view kind) {
    FaultSettings faults;
    for (const FaultInfo& info : known_faults()) {
        if (info.device == "gaze" && info.kind == kind) info.field(faults) = info.typical;
    }
    return faults.gaze;
}

TEST(GazeEndToEnd, SamplesAreTheTruthAtTheirOwnTime) {
    for (const char* name : {"still", "scan", "pursuit", "target"}) {
        for (const std::uint16_t rate_hz : std::array<std::uint16_t, 3>{60, 120, 250}) {
            const Outcome outcome = outcome_of({.motion = name, .rate_hz = rate_hz, .seconds = 10});
            EXPECT_LT(quantile(outcome.sample_error_deg, 1.0), 1e-4) << name;
            EXPECT_LT(outcome.worst_time_error_us, 1.0) << name;
            EXPECT_EQ(outcome.counts.lost + outcome.counts.rejected + outcome.missed_exposures, 0u);
            EXPECT_EQ(outcome.invalid, 0);
        }
    }
}

// Held for the age of a sample at the photon: 13 ms in the tracker, up to a period and a frame, and
// 20 ms of display; at 10 deg/s that is half a degree. Seen: 0.69 at 60 Hz, 0.64 at 250 Hz.
TEST(GazeEndToEnd, AMovingTargetIsSeenALatencyLate) {
    EXPECT_LT(quantile(outcome_of({.motion = "target"}).photon_error_deg, 0.99), 0.75);
    EXPECT_LT(quantile(outcome_of({.motion = "target", .rate_hz = 250}).photon_error_deg, 0.99),
              0.70);
}

// Within fixations only drift is between eye and photon; a saccade less than 50 ms ago is not seen.
TEST(GazeEndToEnd, FixationsAreFollowedAndSaccadesCatchUp) {
    const Outcome outcome = outcome_of({.motion = "scan"});
    EXPECT_LT(quantile(outcome.photon_error_deg, 0.5), 0.08);
    EXPECT_GT(quantile(outcome.photon_error_deg, 0.95), 3.0);
}

TEST(GazeEndToEnd, NoiseIsWhatWasAskedFor) {
    const Outcome outcome =
        outcome_of({.motion = "still", .faults = typical("noise"), .seconds = 120});
    double square = 0.0;
    for (const double error_deg : outcome.sample_error_deg) square += error_deg * error_deg;
    const double rms_deg = std::sqrt(square / static_cast<double>(outcome.sample_error_deg.size()));
    EXPECT_NEAR(rms_deg, 0.75 * 0.12 * std::sqrt(2.0), 0.003);  // two axes, combined
}

TEST(GazeEndToEnd, FaultsAreCounted) {
    EXPECT_NEAR(static_cast<double>(outcome_of({.faults = typical("dropout")}).counts.lost), 36.0,
                24.0);
    EXPECT_NEAR(
        static_cast<double>(outcome_of({.faults = typical("lost_exposure")}).missed_exposures),
        36.0, 24.0);
    const Outcome spoilt = outcome_of({.faults = {.crc_error = 0.02}});
    EXPECT_GT(spoilt.counts.rejected, 10u);
    EXPECT_EQ(spoilt.counts.lost, spoilt.counts.rejected);
    const Outcome doubled = outcome_of({.faults = {.duplicate = 0.02}});
    EXPECT_GT(doubled.counts.rejected, 10u);
    EXPECT_EQ(doubled.counts.lost, 0u);
    EXPECT_GT(outcome_of({.faults = typical("blink")}).invalid, 10);
}

TEST(GazeEndToEnd, AJumpOfTheClockIsSurvived) {
    const Outcome outcome = outcome_of({.motion = "scan", .faults = typical("time_jump")});
    EXPECT_EQ(outcome.counts.rejected, 0u);
    EXPECT_LT(outcome.worst_time_error_us, 1100.0);
    EXPECT_LT(quantile(outcome.sample_error_deg, 1.0), 1e-4);
}

}  // namespace
}  // namespace foverig
