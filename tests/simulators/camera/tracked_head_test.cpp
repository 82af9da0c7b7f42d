// Inertial sensor and camera together, from both devices' bytes to the head's pose, against the
// motion itself.
#include <algorithm>
#include <cmath>

#include "devices/camera/head_camera.h"
#include "devices/fusion/tracked_head.h"
#include "tests/simulators/camera/camera_bench.h"

namespace foverig {
namespace {

using test::at_s;
using test::CameraBench;
using test::CameraRun;

struct Judged {
    double t_s = 0, yaw_deg = 0, tilt_deg = 0, mm = 0;
    dvec3 off_mm{0};
    double step_mm = 0, step_deg = 0;  ///< beyond the truth's own since the row before
    bool lost = false;
};

double yaw_deg(const dquat& error) {
    const dvec3 ahead = error * dvec3(0, 0, -1);
    return glm::degrees(std::atan2(-ahead.x, -ahead.z));
}

/// A row each 5 ms, of the pose of that instant.
std::vector<Judged> judged(const CameraRun& run, double seconds,
                           TrackedHeadCounts* counts = nullptr, double* alone_deg = nullptr) {
    CameraBench bench(run);
    auto imu = dk2::Dk2ImuSource::open(bench.dk2, bench.clock.now(), {.light_leds = true}).value();
    auto camera = camera::HeadCamera::open(bench.device, bench.leds).value();
    const auto truth = [&](HostTime t) { return bench.head->at(to_seconds(t.time_since_epoch())); };
    const dvec3 ahead = truth(at_s(0.001)).world_from_head * dvec3(0, 0, -1);
    TrackedHeadConfig config;
    config.inertial.initial_yaw_rad = std::atan2(-ahead.x, -ahead.z);
    TrackedHead head(config);
    const auto expected = [&](Dk2Time t) { return head.expected(t); };
    std::vector<Judged> rows;
    dvec3 before_mm(0);
    dquat before(1, 0, 0, 0);
    for (double t = 0.005; t < seconds; t += 0.005) {
        bench.clock.sleep_until(at_s(t));
        while (true) {
            auto next = imu.next(bench.clock.now());
            const auto* sample = std::get_if<ImuSample>(&next);
            if (sample == nullptr) break;
            head.add(*sample);
        }
        camera->add(imu.take_exposures());
        while (true) {
            auto next = camera->next(bench.clock.now(), expected);
            const auto* fix = std::get_if<PoseFix>(&next);
            if (fix == nullptr) break;
            head.add(*fix);
        }
        const Pose pose = head.at(bench.clock.now());
        const auto now = truth(bench.clock.now());
        const dquat error = pose.world_from_head * glm::conjugate(now.world_from_head);
        const dvec3 up = error * dvec3(0, 1, 0);
        const dvec3 off_mm = 1e3 * (pose.position_m - now.position_m);
        rows.push_back({.t_s = t,
                        .yaw_deg = yaw_deg(error),
                        .tilt_deg = glm::degrees(std::atan2(std::hypot(up.x, up.z), up.y)),
                        .mm = glm::length(off_mm),
                        .off_mm = off_mm,
                        .step_mm = glm::distance(off_mm, before_mm),
                        .step_deg = glm::degrees(angle_between(error, before)),
                        .lost = head.camera_lost()});
        before_mm = off_mm;
        before = error;
    }
    if (counts != nullptr) *counts = head.counts();
    if (alone_deg != nullptr) {
        const HostTime end = bench.clock.now();
        *alone_deg = glm::degrees(
            angle_between(head.inertial().at(end).world_from_head, truth(end).world_from_head));
    }
    return rows;
}

struct Worst {
    double yaw_deg = 0, tilt_deg = 0, mm = 0, rms_mm = 0, step_mm = 0, step_deg = 0;
};
Worst worst(const std::vector<Judged>& rows, double from_s, double to_s = 1e9) {
    Worst w;
    int n = 0;
    for (const Judged& r : rows) {
        if (r.t_s < from_s || r.t_s > to_s) continue;
        w.yaw_deg = std::max(w.yaw_deg, std::abs(r.yaw_deg));
        w.tilt_deg = std::max(w.tilt_deg, r.tilt_deg);
        w.mm = std::max(w.mm, r.mm);
        w.step_mm = std::max(w.step_mm, r.step_mm);
        w.step_deg = std::max(w.step_deg, r.step_deg);
        w.rms_mm += r.mm * r.mm;
        ++n;
    }
    w.rms_mm = std::sqrt(w.rms_mm / n);
    return w;
}

/// A worn chip on a busy host, its clock 50 ppm off.
const Dk2Faults kUsual{.noise = 1,
                       .low_pass = 250,
                       .quantise = 1,
                       .bias = 0.2,
                       .temperature_drift = 0.01,
                       .random_walk = 3e-5,
                       .clock_drift = 50,
                       .host_delay = 0.2};

// Seen: yaw 0.0215 degrees, tilt 0.015, position 0.047 mm: what is left is the camera's grey
// levels.
TEST(TrackedHead, FollowsEveryMotionToTheCamerasOwnLimit) {
    for (const char* motion : {"still", "look", "stress", "step"}) {
        const Worst w = worst(judged({.motion = motion}, 6), 2);
        EXPECT_LT(w.yaw_deg, 0.04) << motion;
        EXPECT_LT(w.tilt_deg, 0.03) << motion;
        EXPECT_LT(w.mm, 0.15) << motion;
    }
}

// Seen: yaw 0.16 degrees, tilt 0.15, position 0.4 mm rms; the gyro alone is 10 degrees off by then.
TEST(TrackedHead, AMinuteOfBiasAndClockDriftTurnsNothing) {
    TrackedHeadCounts counts;
    double alone_deg = 0;
    const auto rows =
        judged({.motion = "look", .faults = {.noise = 1, .dropout = 0.02}, .dk2 = kUsual}, 65,
               &counts, &alone_deg);
    const Worst w = worst(rows, 2);
    EXPECT_LT(w.yaw_deg, 0.5);
    EXPECT_LT(w.tilt_deg, 0.5);
    EXPECT_LT(w.rms_mm, 2.0);
    EXPECT_LT(w.mm, 5.0);
    EXPECT_GT(counts.fixes, 3600u);
    EXPECT_EQ(counts.restarts, 0u);
    EXPECT_GT(alone_deg, 3.0);
}

// Seen: 2.3 mm and 0.12 degrees of yaw after two seconds, and no step of more than 0.17 mm in 5 ms.
TEST(TrackedHead, HoldsOnWhileTheLedsAreCoveredAndComesBackSmoothly) {
    for (const char* motion : {"look", "stress"}) {
        TrackedHeadCounts counts;
        const auto rows = judged({.motion = motion,
                                  .faults = {.noise = 1, .occlude_at = 5, .occlude_for = 2},
                                  .dk2 = kUsual},
                                 9, &counts);
        const Worst w = worst(rows, 2);
        EXPECT_LT(w.mm, 10.0) << motion;
        EXPECT_LT(w.yaw_deg, 0.5) << motion;
        EXPECT_LT(w.step_mm, 1.0) << motion;
        EXPECT_LT(worst(rows, 7.5).rms_mm, 2.0) << motion;
        EXPECT_TRUE(std::any_of(rows.begin(), rows.end(), [](const Judged& r) {
            return r.lost && r.t_s > 6.0 && r.t_s < 7.0;
        })) << motion;
        EXPECT_FALSE(rows.back().lost) << motion;
        EXPECT_EQ(counts.restarts, 0u) << motion;
    }
}

// A body that walks on is not where a standing neck says: the error is the way that was gone, and
// it is taken back over a few smoothing times.
TEST(TrackedHead, AHiddenWalkIsTakenBackWithoutAJump) {
    TrackedHeadCounts counts;
    const auto seen = judged({.motion = "look",
                              .faults = {.noise = 1, .occlude_at = 5, .occlude_for = 2},
                              .dk2 = kUsual,
                              .sway_m = 0.05},
                             9, &counts);
    // Where the neck was while the camera's place was found out is the world's origin.
    auto rows = seen;
    dvec3 origin_mm(0);
    int n = 0;
    for (const Judged& r : rows) {
        if (r.t_s < 2 || r.t_s > 5) continue;
        origin_mm += r.off_mm;
        ++n;
    }
    origin_mm /= n;
    for (Judged& r : rows) r.mm = glm::distance(r.off_mm, origin_mm);
    EXPECT_LT(worst(rows, 2, 5).rms_mm, 2.0);
    EXPECT_LT(worst(rows, 5, 7.3).mm, 150.0);
    EXPECT_LT(worst(rows, 2).step_mm, 12.0);
    EXPECT_LT(worst(rows, 2).yaw_deg, 0.5);
    EXPECT_LT(worst(rows, 7.6).rms_mm, 3.0);
}

TEST(TrackedHead, GoesOnAfterEitherCableWasOut) {
    for (const bool camera : {true, false}) {
        CameraRun run{.motion = "look"};
        (camera ? run.faults.unplug_at : run.dk2.unplug_at) = 3;
        (camera ? run.faults.unplug_for : run.dk2.unplug_for) = 1;
        TrackedHeadCounts counts;
        const auto rows = judged(run, 8, &counts);
        EXPECT_LT(worst(rows, 6).mm, 5.0) << camera;
        EXPECT_LT(worst(rows, 6).yaw_deg, 0.5) << camera;
        EXPECT_FALSE(rows.back().lost) << camera;
    }
}

TEST(TrackedHead, IsHeadFusionBitForBitWithoutFixes) {
    CameraBench bench({.motion = "look", .dk2 = kUsual});
    auto imu = dk2::Dk2ImuSource::open(bench.dk2, bench.clock.now()).value();
    HeadFusion alone;
    TrackedHead tracked;
    for (int i = 0; i < 3000; ++i) {
        const auto next = imu.next(at_s(0.001 * (i + 2)));
        if (const auto* sample = std::get_if<ImuSample>(&next)) {
            alone.add(*sample);
            tracked.add(*sample);
        }
        const HostTime photon = bench.clock.now() + std::chrono::milliseconds(20);
        const Pose a = alone.at(photon), b = tracked.at(photon);
        ASSERT_EQ(a.world_from_head, b.world_from_head);
        ASSERT_EQ(a.position_m, b.position_m);
    }
}

}  // namespace
}  // namespace foverig
