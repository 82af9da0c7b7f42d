// From the head's motion through the headset's bytes, the decoder, the clock map and the fusion to
// a pose predicted for the photon, against the motion itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include "devices/display/panel_timing.h"
#include "devices/dk2/imu_source.h"
#include "devices/fusion/head_fusion.h"
#include "devices/fusion/rotation.h"
#include "simulators/dk2/simulated_dk2.h"
#include "simulators/motion/catalog.h"

namespace foverig {
namespace {

using std::chrono::milliseconds;

struct Outcome {
    std::vector<double> error_deg;      ///< sorted, one a frame
    double worst_time_error_us = 0;     ///< of the samples' host times
    double worst_gyro_error_rad_s = 0;  ///< against the truth at the samples' host times
    SourceCounts counts;

    double quantile(double p) const {
        return error_deg[static_cast<std::size_t>(p * static_cast<double>(error_deg.size() - 1))];
    }
};

struct Run {
    const char* motion = "still";
    Dk2Faults faults{};
    int seconds = 20;
    int settle_s = 2;                     ///< not judged: the tilt settles
    Nanoseconds ahead{milliseconds(20)};  ///< from the pose to the photon: 1.5 frames
};

/// 75 frames a second, each reading what has arrived and predicting.
Outcome outcome_of(const Run& run) {
    ManualClock clock;
    const auto head = std::move(motion::make_head(run.motion, 21)).value();
    SimulatedDk2 device(clock, *head, {.faults = run.faults, .seed = 21});
    auto opened = dk2::Dk2ImuSource::open(device, clock.now());
    EXPECT_TRUE(opened);
    dk2::Dk2ImuSource source = std::move(opened).value();

    const auto truth = [&](HostTime t) { return head->at(to_seconds(t.time_since_epoch())); };
    // A gyro cannot know where north is.
    const dvec3 ahead = truth(HostTime(milliseconds(1))).world_from_head * dvec3(0, 0, -1);
    HeadFusionConfig config;
    config.initial_yaw_rad = std::atan2(-ahead.x, -ahead.z);
    HeadFusion fusion(config);

    Outcome outcome;
    std::int64_t number = 0;
    for (int frame = 1; frame < 75 * run.seconds; ++frame) {
        clock.sleep_until(HostTime(from_seconds(frame / 75.0)));
        while (true) {
            auto next = source.next(clock.now());
            const auto* sample = std::get_if<ImuSample>(&next);
            if (sample == nullptr) break;
            ++number;
            fusion.add(*sample);
            const HostTime taken(static_cast<std::int64_t>(sample->sequence + 1) * milliseconds(1));
            outcome.worst_time_error_us = std::max(
                outcome.worst_time_error_us, 1e6 * std::abs(to_seconds(sample->host_time - taken)));
            outcome.worst_gyro_error_rad_s =
                std::max(outcome.worst_gyro_error_rad_s,
                         glm::distance(sample->gyro_rad_s, truth(taken).angular_velocity_rad_s));
        }
        const HostTime photon = clock.now() + run.ahead;
        const double error_rad =
            angle_between(fusion.at(photon).world_from_head, truth(photon).world_from_head);
        if (frame > 75 * run.settle_s) outcome.error_deg.push_back(glm::degrees(error_rad));
    }
    std::sort(outcome.error_deg.begin(), outcome.error_deg.end());
    outcome.counts = source.counts();
    return outcome;
}

Dk2Faults typical(std::string_view kind) {
    FaultSettings faults;
    for (const FaultInfo& info : known_faults()) {
        if (info.device == "dk2" && info.kind == kind) info.field(faults) = info.typical;
    }
    return faults.dk2;
}

TEST(HeadEndToEnd, AStillHeadStaysWhereItIs) {
    const Outcome outcome = outcome_of({.motion = "still"});
    EXPECT_LT(outcome.quantile(1.0), 1e-3);
    EXPECT_EQ(outcome.counts.lost + outcome.counts.rejected, 0u);
}

TEST(HeadEndToEnd, SamplesAreTheTruthToQuantisation) {
    for (const char* name : {"look", "stress", "extreme"}) {
        const Outcome outcome = outcome_of({.motion = name, .seconds = 5});
        EXPECT_LE(outcome.worst_gyro_error_rad_s, 0.87e-4) << name;  // half a step on three axes
        // The clock map cannot see the smallest delay, which is the poll phase of 0.1 ms.
        EXPECT_NEAR(outcome.worst_time_error_us, 100.0, 2.0) << name;
    }
}

// Up to 10 deg/s and 3 % of the gyro, 0.18 g and 15 % of the accelerometer; what remains is
// rounding.
TEST(HeadEndToEnd, TheFactoryCalibrationTakesOutWhatTheChipsAreOffBy) {
    const Outcome outcome =
        outcome_of({.motion = "look", .faults = typical("factory"), .seconds = 5});
    EXPECT_LE(outcome.worst_gyro_error_rad_s, 1.0e-4);
    EXPECT_LT(outcome.quantile(0.5), 0.05);
}

// Seen: look 0.030 degrees, step 0.0001, stress 0.444, extreme 0.887; nearly all of it is what 20
// ms at constant angular acceleration cannot know.
TEST(HeadEndToEnd, PredictionKeepsUpWithTheMotion) {
    const Outcome look = outcome_of({.motion = "look"});
    EXPECT_LT(look.quantile(0.5), 0.003);
    EXPECT_LT(look.quantile(1.0), 0.04);
    EXPECT_LT(outcome_of({.motion = "step"}).quantile(1.0), 0.001);
    EXPECT_LT(outcome_of({.motion = "stress"}).quantile(1.0), 0.50);
    EXPECT_LT(outcome_of({.motion = "extreme"}).quantile(1.0), 0.95);
}

TEST(HeadEndToEnd, TrackingAloneLosesHardlyAnything) {
    for (const char* name : {"look", "stress", "extreme"}) {
        const Outcome outcome = outcome_of({.motion = name, .ahead = Nanoseconds{0}});
        EXPECT_LT(outcome.quantile(1.0), 0.04) << name;
    }
}

TEST(HeadEndToEnd, SmallFaultsCostLittle) {
    for (const char* kind :
         {"noise", "low_pass", "quantise", "temperature_drift", "clock_drift", "clock_wander",
          "rate_error", "jitter", "host_delay", "dropout", "backwards_stamp", "wrap"}) {
        const Outcome outcome = outcome_of({.motion = "look", .faults = typical(kind)});
        EXPECT_LT(outcome.quantile(1.0), 0.20) << kind;
    }
}

// A constant gyro bias without a still moment turns the yaw at up to its own rate.
TEST(HeadEndToEnd, BiasMakesTheYawDriftAndNoMore) {
    const Outcome outcome = outcome_of({.motion = "look", .faults = typical("bias")});
    EXPECT_GT(outcome.quantile(1.0), 0.5);
    EXPECT_LT(outcome.quantile(1.0), 0.2 * std::sqrt(3.0) * 20.0);
}

/// Still for a while, then never again: a yaw that swings by 20 degrees at 0.1 Hz.
class RestlessHead final : public motion::HeadMotion {
  public:
    explicit RestlessHead(double still_s) : still_s_(still_s) {}
    motion::HeadState at(double t_s) const override {
        if (t_s < still_s_) return motion::head_from_angles({}, {}, {});
        const double rate_rad_s = 0.2 * std::numbers::pi, yaw_rad = glm::radians(20.0);
        const double phase = rate_rad_s * (t_s - still_s_);
        return motion::head_from_angles(
            {yaw_rad * (1.0 - std::cos(phase)), yaw_rad * rate_rad_s * std::sin(phase),
             yaw_rad * rate_rad_s * rate_rad_s * std::cos(phase)},
            {}, {});
    }

  private:
    double still_s_;
};

struct Warming {
    Dk2Faults faults{.noise = 1.0, .quantise = 1.0, .temperature_drift = 0.01};
    bool learns_slope = true;
};

/// Yaw that is lost between two minutes of rest and ten minutes, while the chip goes from 27.9 to
/// 34.3 C.
double yaw_lost_deg(const Warming& run) {
    constexpr double kStill_s = 120.0, kEnd_s = 600.0;
    ManualClock clock;
    const RestlessHead head(kStill_s);
    SimulatedDk2 device(clock, head, {.faults = run.faults, .seed = 21});
    auto source = std::move(dk2::Dk2ImuSource::open(device, clock.now())).value();
    HeadFusionConfig config;
    if (!run.learns_slope) config.bias.slope_sigma_rad_s_c = 0.0;
    HeadFusion fusion(config);
    const auto yaw_error_rad = [&] {
        const dquat truth = head.at(to_seconds(clock.now().time_since_epoch())).world_from_head;
        const dquat error = fusion.at(clock.now()).world_from_head * glm::conjugate(truth);
        const dvec3 ahead = error * dvec3(0, 0, -1);
        return std::atan2(-ahead.x, -ahead.z);
    };
    double at_rest_rad = 0.0;
    for (double t_s = 0.1; t_s < kEnd_s; t_s += 0.1) {
        clock.sleep_until(HostTime(from_seconds(t_s)));
        while (true) {
            auto next = source.next(clock.now());
            const auto* sample = std::get_if<ImuSample>(&next);
            if (sample == nullptr) break;
            fusion.add(*sample);
        }
        if (t_s <= kStill_s) at_rest_rad = yaw_error_rad();
    }
    return glm::degrees(std::abs(yaw_error_rad() - at_rest_rad));
}

// T(t) = 38 - 13 exp(-t / 480 s). After 120 s the bias is learnt at 27.8 C, and moves with the chip
// by 0.01 deg/s/C from there: the integral to 600 s is 18.2 degrees of yaw. A slope of 20 still
// moments is known to 11 % (GyroBias, LearnsItsSlopeWithTemperature), and is judged at four times
// that. Seen: 19.2 degrees, and 2.4.
TEST(HeadEndToEnd, AWarmingGyroDriftsByItsSlopeUnlessThatIsLearnt) {
    const auto celsius = [](double t_s) { return 38.0 - 13.0 * std::exp(-t_s / 480.0); };
    double expected_deg = 0.0;
    for (double t_s = 120.0; t_s < 600.0; t_s += 0.1) {
        expected_deg += 0.1 * 0.01 * (celsius(t_s) - celsius(117.0));
    }
    EXPECT_NEAR(yaw_lost_deg({.learns_slope = false}), expected_deg, 0.15 * expected_deg);
    EXPECT_LT(yaw_lost_deg({}), 0.44 * expected_deg);
}

// Of a bias of some 0.2 deg/s the headset's own table leaves its rounding, half a report unit at
// each of two temperatures: at most 0.0057 deg/s, 2.7 degrees in the 480 s. The still moment's own
// noise, 4e-5 rad/s, is another 1.1 at one sigma. Seen: 1.7.
TEST(HeadEndToEnd, AHeadsetThatKnowsItsBiasByTemperatureHardlyDrifts) {
    Warming run;
    run.faults.bias = 0.2;
    run.faults.temperature_table = 1.0;
    run.learns_slope = false;
    EXPECT_LT(yaw_lost_deg(run), 2.7 + 1.1);
}

TEST(HeadEndToEnd, LossesAndOldStampsAreCounted) {
    const Outcome dropout = outcome_of({.motion = "look", .faults = typical("dropout")});
    EXPECT_NEAR(static_cast<double>(dropout.counts.lost), 0.01 * 20000.0, 60.0);
    EXPECT_EQ(dropout.counts.samples + dropout.counts.lost, 19986u);
    const Outcome backwards = outcome_of({.motion = "look", .faults = typical("backwards_stamp")});
    EXPECT_NEAR(static_cast<double>(backwards.counts.rejected), 20.0, 18.0);
}

TEST(HeadEndToEnd, GoesOnAfterTheCableWasOut) {
    Dk2Faults faults;
    faults.unplug_at = 5.0;
    faults.unplug_for = 1.0;
    const Outcome outcome = outcome_of({.motion = "still", .faults = faults, .seconds = 15});
    EXPECT_EQ(outcome.counts.reconnects, 1u);
    EXPECT_LT(outcome.error_deg.back(), 0.1);
    EXPECT_GT(outcome.counts.samples, 13000u);
}

}  // namespace
}  // namespace foverig
