#include "devices/gaze/calibration.h"

#include <gmock/gmock.h>

#include "devices/gaze/calibration_targets.h"
#include "devices/gaze/requests.h"

namespace foverig::gaze {
namespace {

using testing::HasSubstr;
using Task = CalibrationProcedure::Task;
using State = CalibrationProcedure::State;

HostTime at(double s) {
    return HostTime(from_seconds(s));
}

/// A procedure in the hands of a tracker and eyes that the test plays.
struct Played {
    explicit Played(Task task, int points = 5)
        : procedure(task, targets_deg(points, 16.0), at(0.0)) {}

    CalibrationProcedure procedure;
    double now_s = 0.0;

    /// The request's number; 0: there is none.
    int order() {
        last = procedure.next_order(at(now_s));
        return last ? last->request : 0;
    }
    void tell(CalibrationState state, int point = 0,
              CalibrationReason reason = CalibrationReason::none) {
        CalibrationFrame frame{
            .current_point = static_cast<std::uint8_t>(point), .state = state, .reason = reason};
        frame.header.queued_ns = static_cast<std::uint64_t>(now_s * 1e9);
        if (state == CalibrationState::done) frame.accuracy_deg = {0.5F, 0.6F};
        procedure.take(frame, at(now_s));
    }
    /// Samples at 60 Hz while both eyes rest, or turn by `speed_deg_s`; the target 1.5 m away.
    void look(double seconds, const dvec2& at_deg = dvec2(0.0), double speed_deg_s = 0.0) {
        for (const double end_s = now_s + seconds; now_s < end_s; now_s += 1.0 / 60.0) {
            turned_deg += speed_deg_s / 60.0;
            procedure.take(sample(at_deg + dvec2(turned_deg, 0.0)));
        }
    }
    void blink() {
        GazeSample sample;
        sample.device_time = GazeTime(from_seconds(now_s));
        procedure.take(sample);
    }
    GazeSample sample(const dvec2& at_deg) const {
        GazeSample s;
        s.device_time = GazeTime(from_seconds(now_s));
        s.combined = {.valid = true, .direction = gaze_direction(at_deg)};
        for (const auto& [eye, x_m] : {std::pair{&s.left, -0.032}, {&s.right, 0.032}}) {
            const dvec3 base_m(x_m, 0.0, 0.0);
            eye->state = EyeState::tracked;
            eye->ray = {.valid = true,
                        .base_point_m = base_m,
                        .direction = glm::normalize(1.5 * gaze_direction(at_deg) - base_m)};
        }
        return s;
    }

    std::optional<CalibrationProcedure::Order> last;
    double turned_deg = 0.0;
};

TEST(CalibrationProcedure, SendsItsTargetsInPixels) {
    Played p(Task::calibrate, 3);
    EXPECT_EQ(p.order(), request::cal_start);
    EXPECT_EQ(p.last->value, 3);
    const auto px = decode_targets(p.last->data);
    ASSERT_TRUE(px);
    ASSERT_EQ(px->size(), 3U);
    EXPECT_EQ((*px)[1], por_of(targets_deg(3, 16.0)[1]));
    EXPECT_EQ(p.order(), 0) << "once";
    Played v(Task::validate, 9);
    EXPECT_EQ(v.order(), request::validate);
    Played none(Task::calibrate, 0);
    EXPECT_EQ(none.order(), request::cal_start);
    EXPECT_TRUE(none.last->data.empty());
    none.tell(CalibrationState::done);
    EXPECT_EQ(none.procedure.state(), State::done);
}

TEST(CalibrationProcedure, AcceptsOnceTheEyesRest) {
    Played p(Task::calibrate);
    p.order();
    EXPECT_FALSE(p.procedure.shown());
    p.tell(CalibrationState::waiting, 0);
    EXPECT_EQ(p.procedure.shown(), 0U);
    p.look(0.6);
    EXPECT_EQ(p.order(), 0) << "a target is looked for first";
    p.look(0.2);
    EXPECT_EQ(p.order(), request::cal_accept);
    EXPECT_EQ(p.order(), 0);
    p.tell(CalibrationState::collecting);
    EXPECT_TRUE(p.procedure.collecting());
    p.tell(CalibrationState::point_accepted);
    EXPECT_FALSE(p.procedure.shown());
    p.tell(CalibrationState::waiting, 1);
    EXPECT_EQ(p.procedure.shown(), 1U);
}

// I-VT's 30 deg/s (DEVICES.md 4.4).
TEST(CalibrationProcedure, WaitsForEyesThatMoveOrBlink) {
    for (const auto& [speed_deg_s, rests] : {std::pair{25.0, true}, {35.0, false}}) {
        Played p(Task::calibrate);
        p.order();
        p.tell(CalibrationState::waiting, 0);
        p.look(1.0, {-15.0, 0.0}, speed_deg_s);
        EXPECT_EQ(p.order() == request::cal_accept, rests) << speed_deg_s;
    }
    Played p(Task::calibrate);
    p.order();
    p.tell(CalibrationState::waiting, 0);
    p.look(0.9);
    p.blink();
    EXPECT_EQ(p.order(), 0);
    p.look(0.1);
    EXPECT_EQ(p.order(), 0);
    p.look(0.1);
    EXPECT_EQ(p.order(), request::cal_accept);
}

TEST(CalibrationProcedure, TriesATargetAgainAndNotForEver) {
    Played p(Task::calibrate);
    p.order();
    p.tell(CalibrationState::waiting, 0);
    for (int attempt = 1; attempt <= 5; ++attempt) {
        ASSERT_EQ(p.procedure.state(), State::running) << attempt;
        p.look(0.9);
        ASSERT_EQ(p.order(), request::cal_accept) << attempt;
        p.tell(CalibrationState::collecting);
        p.look(0.5);
        p.tell(CalibrationState::point_rejected, 0, CalibrationReason::no_eyes);
        EXPECT_EQ(p.procedure.targets()[0].attempts, attempt);
        p.tell(CalibrationState::waiting, 0);
    }
    EXPECT_EQ(p.procedure.state(), State::failed);
    EXPECT_THAT(p.procedure.failure(),
                HasSubstr("target 1 of 5 was refused 5 times: the eyes were not seen long enough"));
    EXPECT_EQ(p.order(), request::cal_abort) << "the tracker must know";
    EXPECT_EQ(p.order(), 0);
}

TEST(CalibrationProcedure, GivesUpOnEyesThatNeverRestAndTrackersThatSayNothing) {
    Played eyes(Task::calibrate);
    eyes.order();
    eyes.tell(CalibrationState::waiting, 0);
    eyes.now_s += 10.1;
    EXPECT_EQ(eyes.order(), request::cal_abort);
    EXPECT_THAT(eyes.procedure.failure(), HasSubstr("did not rest on target 1 of 5 within 10 s"));

    Played tracker(Task::calibrate);
    tracker.order();
    tracker.now_s += 3.1;
    EXPECT_EQ(tracker.order(), request::cal_abort);
    EXPECT_THAT(tracker.procedure.failure(), HasSubstr("does not answer"));
}

TEST(CalibrationProcedure, EndsWhereItIsToldTo) {
    Played p(Task::calibrate);
    p.order();
    p.tell(CalibrationState::waiting, 0);
    p.procedure.abort();
    EXPECT_EQ(p.procedure.state(), State::aborted);
    EXPECT_EQ(p.order(), request::cal_abort);
    p.tell(CalibrationState::waiting, 1);
    EXPECT_FALSE(p.procedure.shown());

    Played refused(Task::calibrate);
    refused.order();
    refused.procedure.refused("the tracker stalls");
    EXPECT_EQ(refused.procedure.state(), State::failed);
    EXPECT_EQ(refused.order(), 0);

    Played lost(Task::calibrate);
    lost.order();
    lost.tell(CalibrationState::failed, 0, CalibrationReason::timed_out);
    EXPECT_THAT(lost.procedure.failure(), HasSubstr("nobody accepted the point in time"));

    Played foreign(Task::calibrate);
    foreign.order();
    foreign.tell(CalibrationState::waiting, 7);
    EXPECT_EQ(foreign.procedure.state(), State::failed) << "there are five";
}

TEST(CalibrationProcedure, MeasuresWhatWasSeenWhileATargetWasWatched) {
    Played p(Task::validate, 1);
    p.order();
    p.tell(CalibrationState::waiting, 0);
    p.look(0.9, {9.0, 9.0});  // where the eyes are before does not count
    ASSERT_EQ(p.order(), request::cal_accept);
    p.tell(CalibrationState::collecting);
    p.look(0.5, {0.0, 2.0});
    p.tell(CalibrationState::done);
    EXPECT_EQ(p.procedure.state(), State::done);
    const auto& target = p.procedure.targets()[0];
    EXPECT_NEAR(static_cast<double>(target.combined.samples), 30.0, 1.0);
    EXPECT_NEAR(target.combined.accuracy_deg, 2.0, 1e-9);
    // From an eye 32 mm aside the two places 1.5 m away are as far apart to within a thousandth.
    EXPECT_NEAR(target.left.accuracy_deg, 2.0, 2e-3);
    EXPECT_NEAR(target.right.accuracy_deg, 2.0, 2e-3);
    EXPECT_NEAR(target.combined.sd_deg, 0.0, 1e-6);
    EXPECT_EQ(target.told_accuracy_deg, (Vec2f{0.5F, 0.6F}));
}

}  // namespace
}  // namespace foverig::gaze
