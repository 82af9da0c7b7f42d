// The host's calibration with the simulated tracker and person, over the bytes between them.
#include <gtest/gtest.h>

#include "devices/gaze/calibration.h"
#include "devices/gaze/calibration_targets.h"
#include "devices/gaze/gaze_source.h"
#include "simulators/gaze/simulated_gaze.h"
#include "simulators/motion/guided_eye.h"

namespace foverig {
namespace {

using gaze::CalibrationProcedure;
using Task = CalibrationProcedure::Task;
using State = CalibrationProcedure::State;

class CalibratedPerson {
  public:
    CalibratedPerson(const GazeFaults& faults, std::uint64_t seed, std::uint16_t rate_hz = 60)
        : eyes_(seed),
          tracker_(clock_, eyes_, {.faults = faults, .seed = seed}),
          source_(gaze::GazeSource::open(tracker_, clock_, {.rate_hz = rate_hz}).value()) {}

    /// Until it is over, or the tracker is gone.
    CalibrationProcedure run(Task task, const std::vector<dvec2>& targets) {
        CalibrationProcedure procedure(task, targets, clock_.now());
        std::optional<std::size_t> looked_at;
        while (true) {
            while (const auto order = procedure.next_order(clock_.now())) {
                const auto status = tracker_.control_set(order->request, order->value, order->data);
                if (!status) procedure.refused(status.error().text);
            }
            if (procedure.state() != State::running) return procedure;
            if (procedure.shown() && procedure.shown() != looked_at) {
                looked_at = procedure.shown();
                eyes_.show(to_seconds(clock_.now().time_since_epoch()), targets[*looked_at]);
            }
            const auto next = source_.next(clock_.now() + Nanoseconds(10'000'000));
            for (const auto& frame : source_.take_calibrations())
                procedure.take(frame, clock_.now());
            if (const auto* sample = std::get_if<GazeSample>(&next)) procedure.take(*sample);
            if (const auto* fault = std::get_if<Fault>(&next)) procedure.refused(fault->error.text);
        }
    }
    double validated_deg() {
        const auto procedure = run(Task::validate, gaze::targets_deg(9, 12.0));
        EXPECT_EQ(procedure.state(), State::done) << procedure.failure();
        std::vector<gaze::DataQuality> left, right;
        for (const auto& target : procedure.targets()) {
            left.push_back(target.left);
            right.push_back(target.right);
            // Both sides judge the same samples.
            EXPECT_NEAR(target.left.accuracy_deg, target.told_accuracy_deg[0], 1e-3);
            EXPECT_NEAR(target.right.accuracy_deg, target.told_accuracy_deg[1], 1e-3);
            EXPECT_NEAR(target.left.rms_s2s_deg, target.told_rms_s2s_deg[0], 1e-3);
        }
        return 0.5 * (mean_of(left).accuracy_deg + mean_of(right).accuracy_deg);
    }
    HostTime now() const { return clock_.now(); }

  private:
    ManualClock clock_;
    motion::GuidedEye eyes_;
    SimulatedGaze tracker_;
    gaze::GazeSource source_;
};

class EachRate : public testing::TestWithParam<std::uint16_t> {};
INSTANTIATE_TEST_SUITE_P(Rates, EachRate, testing::Values(60, 120, 250));

TEST_P(EachRate, APersonIsCalibratedBetterWithMorePoints) {
    double former_deg = 1e9;
    for (const int points : {0, 1, 5, 9}) {
        double mean_deg = 0.0;
        constexpr int kPeople = 4;
        for (std::uint64_t seed = 0; seed < kPeople; ++seed) {
            CalibratedPerson person({.noise = 0.12, .user = 1.0}, seed, GetParam());
            const auto done = person.run(Task::calibrate, gaze::targets_deg(points, 16.0));
            ASSERT_EQ(done.state(), State::done) << done.failure();
            mean_deg += person.validated_deg() / kPeople;
        }
        EXPECT_LT(mean_deg, 0.95 * former_deg) << points;
        if (points == 0) {
            EXPECT_GT(mean_deg, 4.0);
        }
        former_deg = mean_deg;
    }
    EXPECT_LT(former_deg, 0.45) << "noise of 0.12 degrees an axis, and drift, are in it";
}

TEST(CalibrationEndToEnd, TakesTheTimeOfLookingAndWatching) {
    CalibratedPerson person({.user = 1.0}, 1);
    const auto done = person.run(Task::calibrate, gaze::targets_deg(5, 16.0));
    ASSERT_EQ(done.state(), State::done) << done.failure();
    // 0.7 s to look, 0.5 s to be watched, and what the bytes take.
    EXPECT_GT(to_seconds(person.now().time_since_epoch()), 5 * 1.2);
    EXPECT_LT(to_seconds(person.now().time_since_epoch()), 5 * 1.5);
}

TEST(CalibrationEndToEnd, BlinksAreTriedAgain) {
    int attempts = 0, targets = 0;
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        CalibratedPerson person({.noise = 0.12, .user = 1.0, .blink = 40.0}, seed);
        const auto done = person.run(Task::calibrate, gaze::targets_deg(9, 16.0));
        ASSERT_EQ(done.state(), State::done) << done.failure();
        for (const auto& target : done.targets()) attempts += target.attempts;
        targets += 9;
    }
    EXPECT_GT(attempts, targets);
}

TEST(CalibrationEndToEnd, LostSamplesDoNotStopIt) {
    CalibratedPerson person({.user = 1.0, .dropout = 0.02, .lost_exposure = 0.02}, 3);
    const auto done = person.run(Task::calibrate, gaze::targets_deg(5, 16.0));
    EXPECT_EQ(done.state(), State::done) << done.failure();
}

TEST(CalibrationEndToEnd, UnpluggedInTheMiddleIsAFault) {
    CalibratedPerson person({.user = 1.0, .unplug_at = 3.0, .unplug_for = 1.0}, 1);
    const auto gone = person.run(Task::calibrate, gaze::targets_deg(9, 16.0));
    EXPECT_EQ(gone.state(), State::failed);
    EXPECT_EQ(gone.failure(), "the simulated gaze tracker is unplugged (faults.gaze.unplug_at)");
}

}  // namespace
}  // namespace foverig
