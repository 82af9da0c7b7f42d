// Calibration and validation of the simulated tracker, over its bytes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/simulators/gaze/calibration_bench.h"

namespace foverig {
namespace {

using gaze::CalibrationReason;
using gaze::CalibrationState;
using gaze::DeviceState;
using test::CalibrationBench;
namespace request = gaze::request;
namespace status_bit = gaze::sample_status;

SimulatedGaze::Settings person(std::uint64_t seed, double noise = 0.0) {
    return {.faults = {.noise = noise, .user = 1.0}, .seed = seed};
}

TEST(GazeCalibration, TakesTheNumbersOfPointsThatTheProtocolHas) {
    CalibrationBench tracker;
    EXPECT_FALSE(tracker.order(request::cal_start, 5)) << "before START";
    ASSERT_TRUE(tracker.order(request::start));
    for (const std::uint16_t points :
         std::initializer_list<std::uint16_t>{2, 4, 6, 7, 8, 10, 12, 14, 255})
        EXPECT_FALSE(tracker.order(request::cal_start, points)) << points;
    for (const std::uint16_t points : std::initializer_list<std::uint16_t>{1, 3, 5, 9, 13}) {
        ASSERT_TRUE(tracker.order(request::cal_start, points)) << points;
        EXPECT_EQ(tracker.status().state, DeviceState::calibrating);
        ASSERT_TRUE(tracker.order(request::cal_abort));
        EXPECT_EQ(tracker.status().state, DeviceState::streaming);
    }
}

TEST(GazeCalibration, RefusesWhatDoesNotFitItsState) {
    CalibrationBench tracker;
    ASSERT_TRUE(tracker.order(request::start));
    EXPECT_FALSE(tracker.order(request::cal_accept));
    EXPECT_FALSE(tracker.order(request::cal_abort));
    const auto three = CalibrationBench::pairs(gaze::targets_deg(3, 10.0));
    EXPECT_FALSE(tracker.order(request::cal_start, 5, three)) << "three targets for five points";
    EXPECT_FALSE(tracker.order(request::cal_start, 3, Bytes(three).first(12)));
    EXPECT_FALSE(tracker.order(request::validate, 0));
    const gaze::Vec2f outside[] = {{961.0F, 5.0F}};
    EXPECT_FALSE(tracker.order(request::cal_start, 1, gaze::encode_targets(outside)));
    ASSERT_TRUE(tracker.order(request::cal_start, 3, three));
    EXPECT_FALSE(tracker.order(request::cal_start, 3)) << "one at a time";
    EXPECT_FALSE(tracker.order(request::cal_start, 0));
    EXPECT_FALSE(tracker.order(request::validate, 3, three));
    EXPECT_FALSE(tracker.order(request::start));
    EXPECT_FALSE(tracker.order(request::set_rate, 60));
    ASSERT_TRUE(tracker.order(request::cal_accept));
    EXPECT_FALSE(tracker.order(request::cal_accept)) << "it is watching";
    ASSERT_TRUE(tracker.order(request::stop));
    EXPECT_FALSE(tracker.order(request::cal_accept)) << "STOP ends it";
}

TEST(GazeCalibration, TellsEachStepInFramesOfTheSession) {
    CalibrationBench tracker(person(1));
    ASSERT_TRUE(tracker.order(request::start));
    ASSERT_TRUE(tracker.order(request::cal_start, 3));  // the default points
    tracker.pass(0.1);
    ASSERT_EQ(tracker.told.size(), 1U);
    const gaze::CalibrationFrame first = tracker.told[0];
    EXPECT_EQ(first.state, CalibrationState::waiting);
    EXPECT_EQ(first.points, 3);
    EXPECT_EQ(first.current_point, 0);
    EXPECT_EQ(first.calibration_id, 1U);
    EXPECT_EQ(first.target_por_px, (gaze::Vec2f{480.0F, 540.0F}));
    EXPECT_NEAR(first.target_direction[2], 1.0, 1e-6) << "z forward";
    EXPECT_TRUE(std::isnan(first.accuracy_deg[0]));
    EXPECT_EQ(first.header.session, tracker.samples.back().header.session);
    EXPECT_NE(tracker.samples.back().status & status_bit::calibrating, 0);

    ASSERT_TRUE(tracker.order(request::cal_accept));
    tracker.pass(0.6);
    const gaze::Vec2f second = tracker.told.back().target_por_px;
    EXPECT_EQ(second, (gaze::Vec2f{240.0F, 378.0F}));
    EXPECT_EQ(tracker.states(),
              (std::vector{CalibrationState::waiting, CalibrationState::collecting,
                           CalibrationState::point_accepted, CalibrationState::waiting}));
    for (int point = 1; point < 3; ++point) {
        tracker.look(gaze::target_deg_of(point == 1 ? second : gaze::Vec2f{720.0F, 702.0F}));
        tracker.pass(0.1);
        ASSERT_TRUE(tracker.order(request::cal_accept));
        tracker.pass(0.6);
    }
    ASSERT_FALSE(tracker.told.empty());
    EXPECT_EQ(tracker.told.back().state, CalibrationState::done);
    EXPECT_FALSE(std::isnan(tracker.told.back().accuracy_deg[0]));
    const auto status = tracker.status();
    EXPECT_EQ(status.calibration_id, 1);
    EXPECT_EQ(status.calibration_points, 3);
    EXPECT_NE(status.calibration_quality, 255);
    EXPECT_EQ(status.last_error, 0);
    EXPECT_EQ(tracker.samples.back().calibration_points, 3);
    EXPECT_EQ(tracker.samples.back().status & (status_bit::calibrating | status_bit::uncalibrated),
              0);
    // Frames of all types share one count.
    std::uint32_t frames = 0;
    for (const auto& sample : tracker.samples) frames = std::max(frames, sample.header.sequence);
    EXPECT_GE(frames + 1, tracker.samples.size() + 10U);
}

TEST(GazeCalibration, TakesTheTargetThatAcceptNames) {
    CalibrationBench tracker(person(1));
    ASSERT_TRUE(tracker.order(request::start));
    ASSERT_TRUE(tracker.order(request::cal_start, 1));
    const dvec2 elsewhere(6.0, -4.0);
    tracker.look(elsewhere);
    tracker.pass(0.1);
    ASSERT_TRUE(tracker.order(request::cal_accept, 0, CalibrationBench::pairs({elsewhere})));
    tracker.pass(0.6);
    EXPECT_LT(tracker.error_deg(Side::left, elsewhere), 1e-3);
}

// The quadratic error of DEVICES.md 5.5 is 0.5 (y/20)^2 and 0.5 (x/20)^2 degrees.
TEST(GazeCalibration, LeavesTheErrorThatTheArithmeticLeaves) {
    const double corner = 0.5 * 0.8 * 0.8;  // at 16 degrees: 0.32 on each axis
    const auto bench = [] {
        return CalibrationBench({.faults = {.offset = 2.0, .crosstalk = 0.5}, .seed = 4});
    };
    // A point in the middle takes the offset away, and what the eyes' convergence adds.
    auto one = bench();
    ASSERT_TRUE(one.order(request::start));
    EXPECT_GT(one.error_deg(Side::left, {0, 0}), 1.0);
    ASSERT_TRUE(one.calibrate(1));
    EXPECT_LT(one.error_deg(Side::left, {0, 0}), 1e-4);
    // The error is in azimuth, which shrinks with the elevation's cosine.
    EXPECT_NEAR(one.error_deg(Side::left, {0, 16}), corner * std::cos(glm::radians(16.0)), 1e-3);
    // Of a constant, least squares leave 1/5 at the corners and 4/5 in the middle.
    auto five = bench();
    ASSERT_TRUE(five.order(request::start));
    ASSERT_TRUE(five.calibrate(5));
    EXPECT_NEAR(five.error_deg(Side::right, {0, 0}), 0.8 * corner * std::sqrt(2.0), 0.01);
    EXPECT_NEAR(five.error_deg(Side::right, {16, 16}), 0.2 * corner * std::sqrt(2.0), 0.01);
    auto nine = bench();
    ASSERT_TRUE(nine.order(request::start));
    ASSERT_TRUE(nine.calibrate(9));
    // All but 1/60 of a quadratic: the error is one of where the eye looks, the correction one of
    // what is measured.
    EXPECT_LT(nine.mean_error_deg(), corner / 60.0);
}

TEST(GazeCalibration, MorePointsAreBetter) {
    double before = 0.0;
    std::array<double, 5> after{};
    constexpr int kPeople = 8;
    for (std::uint64_t seed = 0; seed < kPeople; ++seed) {
        CalibrationBench tracker(person(seed));
        ASSERT_TRUE(tracker.order(request::start));
        before += tracker.mean_error_deg() / kPeople;
        EXPECT_NE(tracker.samples.back().status & status_bit::uncalibrated, 0);
        for (std::size_t i = 0; i < after.size(); ++i) {
            ASSERT_TRUE(tracker.calibrate(std::array{1, 3, 5, 9, 13}[i]));
            after[i] += tracker.mean_error_deg() / kPeople;
        }
    }
    const std::string all = fmt::format("{:.3f}: {:.3f} {:.3f} {:.3f} {:.3f} {:.3f}", before,
                                        after[0], after[1], after[2], after[3], after[4]);
    RecordProperty("mean_error_deg", all);
    EXPECT_GT(before, 4.0) << all;
    EXPECT_LT(after[0], 0.5 * before) << all;
    for (std::size_t i = 1; i < after.size(); ++i) EXPECT_LT(after[i], 0.9 * after[i - 1]) << all;
    EXPECT_LT(after[4], 0.1) << all;
}

TEST(GazeCalibration, AlsoWhereMeasuringIsNoisy) {
    std::array<double, 3> after{};
    constexpr int kPeople = 6;
    for (std::uint64_t seed = 0; seed < kPeople; ++seed)
        for (std::size_t i = 0; i < after.size(); ++i) {
            CalibrationBench tracker(person(seed, 0.12));
            ASSERT_TRUE(tracker.order(request::start));
            ASSERT_TRUE(tracker.calibrate(std::array{1, 5, 9}[i]));
            after[i] += tracker.mean_error_deg() / kPeople;
        }
    EXPECT_GT(after[0], after[1]);
    EXPECT_GT(after[1], after[2]);
}

TEST(GazeCalibration, AbortKeepsTheFormerOneAndZeroPointsForgetIt) {
    CalibrationBench tracker(person(2));
    ASSERT_TRUE(tracker.order(request::start));
    ASSERT_TRUE(tracker.calibrate(5));
    const double calibrated = tracker.mean_error_deg();
    ASSERT_TRUE(tracker.order(request::cal_start, 1));
    tracker.told.clear();
    ASSERT_TRUE(tracker.order(request::cal_abort));
    tracker.pass(0.1);
    ASSERT_FALSE(tracker.told.empty());
    EXPECT_EQ(tracker.told.back().state, CalibrationState::aborted);
    EXPECT_EQ(tracker.told.back().reason, CalibrationReason::host_abort);
    EXPECT_EQ(tracker.status().calibration_points, 5);
    EXPECT_NEAR(tracker.mean_error_deg(), calibrated, 1e-9);

    ASSERT_TRUE(tracker.order(request::cal_start, 0));
    EXPECT_EQ(tracker.status().calibration_id, 0);
    EXPECT_GT(tracker.mean_error_deg(), 4.0);
}

TEST(GazeCalibration, RefusesAPointWhereTheEyesAreLost) {
    CalibrationBench tracker;
    ASSERT_TRUE(tracker.order(request::start));
    ASSERT_TRUE(tracker.order(request::cal_start, 1));
    ASSERT_TRUE(tracker.order(request::cal_accept));
    ASSERT_TRUE(tracker.order(
        request::sim_fault, 0,
        gaze::SimFault{.kind = gaze::FaultKind::eye_lost, .duration_ms = 200}.encode()));
    tracker.pass(0.6);
    ASSERT_EQ(tracker.told.size(), 4U);
    EXPECT_EQ(tracker.told[2].state, CalibrationState::point_rejected);
    EXPECT_EQ(tracker.told[2].reason, CalibrationReason::no_eyes);
    EXPECT_EQ(tracker.told[3].state, CalibrationState::waiting) << "the same point again";
    EXPECT_EQ(tracker.status().last_error, static_cast<int>(CalibrationReason::no_eyes));
    ASSERT_TRUE(tracker.order(request::cal_accept));
    tracker.pass(0.6);
    EXPECT_EQ(tracker.told.back().state, CalibrationState::done);
}

TEST(GazeCalibration, RefusesAPointWhereTheEyeMovesOrNoiseIsTooMuch) {
    CalibrationBench tracker;
    ASSERT_TRUE(tracker.order(request::start));
    ASSERT_TRUE(tracker.order(request::cal_start, 1));
    ASSERT_TRUE(tracker.order(request::cal_accept));
    tracker.pass(0.25);
    tracker.look({5.0, 0.0});
    tracker.pass(0.35);
    ASSERT_GE(tracker.told.size(), 3U);
    EXPECT_EQ(tracker.told[2].reason, CalibrationReason::unstable);

    CalibrationBench noisy({.faults = {.noise = 2.0}, .seed = 1});
    ASSERT_TRUE(noisy.order(request::start));
    EXPECT_FALSE(noisy.calibrate(1));
    EXPECT_EQ(noisy.status().last_error, static_cast<int>(CalibrationReason::unstable));
}

TEST(GazeCalibration, TimesOutWhereNobodyAccepts) {
    CalibrationBench tracker;
    ASSERT_TRUE(tracker.order(request::start));
    ASSERT_TRUE(tracker.order(request::cal_start, 5));
    tracker.pass(31.0);
    EXPECT_EQ(tracker.told.back().state, CalibrationState::failed);
    EXPECT_EQ(tracker.told.back().reason, CalibrationReason::timed_out);
    EXPECT_EQ(tracker.status().state, DeviceState::streaming);
}

TEST(GazeCalibration, IsTheSameInAnotherTrackerThatIsGivenIt) {
    CalibrationBench first(person(3)), second(person(3));
    for (auto* tracker : {&first, &second}) ASSERT_TRUE(tracker->order(request::start));
    ASSERT_TRUE(first.calibrate(9));
    const auto blob = first.device.control_get(request::cal_blob, 0, 512);
    ASSERT_TRUE(blob);
    ASSERT_TRUE(second.order(request::cal_blob, 0, *blob));
    EXPECT_EQ(second.status().calibration_points, 9);
    EXPECT_EQ(second.status().calibration_quality, first.status().calibration_quality);
    EXPECT_EQ(first.error_deg(Side::left, {5, 5}), second.error_deg(Side::left, {5, 5}));
    EXPECT_EQ(*second.device.control_get(request::cal_blob, 0, 512), *blob);

    auto torn = *blob;
    torn[100] ^= std::byte{1};
    EXPECT_FALSE(second.order(request::cal_blob, 0, torn));
    EXPECT_FALSE(second.order(request::cal_blob, 0,
                              gaze::CalibrationBlob{.id = 7, .data = {std::byte{1}}}.encode()));
    EXPECT_EQ(second.status().calibration_points, 9) << "the former one stands";
}

TEST(GazeCalibration, ValidationSaysAccuracyAndPrecisionOfEachTarget) {
    CalibrationBench tracker({.faults = {.noise = 0.12, .offset = 1.0}, .seed = 5});
    ASSERT_TRUE(tracker.order(request::start));
    const std::vector<dvec2> targets{{0, 0}, {10, 0}, {0, -10}};
    ASSERT_TRUE(tracker.do_points(request::validate, targets));
    std::vector<gaze::CalibrationFrame> done;
    for (const auto& frame : tracker.told)
        if (frame.state == CalibrationState::done) done.push_back(frame);
    ASSERT_EQ(done.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(done[i].current_point, i);
        const double here = tracker.error_deg(Side::left, targets[i]);  // of one sample
        EXPECT_NEAR(done[i].accuracy_deg[0], here, 0.6);
        // RMS-S2S of both axes of white noise with lag-1 correlation 0.3 (5.5): 0.142 sqrt(2).
        const double ecc = glm::length(targets[i]) / 20.0;
        EXPECT_NEAR(done[i].precision_deg[0], 0.142 * std::sqrt(2.0) * (1.0 + ecc * ecc), 0.06);
    }
    EXPECT_EQ(tracker.status().calibration_id, 1) << "nothing was calibrated";
}

TEST(GazeCalibration, AnAverageUserNeedsNone) {
    CalibrationBench tracker;
    ASSERT_TRUE(tracker.order(request::start));
    EXPECT_LT(tracker.mean_error_deg(), 1e-4);
    ASSERT_TRUE(tracker.calibrate(13));
    EXPECT_LT(tracker.mean_error_deg(), 1e-3);
}

}  // namespace
}  // namespace foverig
