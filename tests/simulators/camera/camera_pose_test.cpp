// From light on the simulated sensor through frames, spots, blink codes and perspective-n-point to
// the headset's pose, against the motion itself.
#include <algorithm>
#include <cmath>

#include "tests/simulators/camera/camera_bench.h"

namespace foverig {
namespace {

using test::at_s;
using test::CameraBench;
using test::CameraRun;

struct PoseErrors {
    std::vector<double> mm, deg;  ///< sorted, one a pose
    camera::LedTrackerCounts counts;
    SourceCounts frames;
    int first_pose_exposure = -1;

    static double quantile(const std::vector<double>& v, double p) {
        return v.empty() ? NAN : v[static_cast<std::size_t>(p * static_cast<double>(v.size() - 1))];
    }
};

PoseErrors errors_of(const CameraRun& run, double seconds = 3.0) {
    CameraBench bench(run);
    auto imu = dk2::Dk2ImuSource::open(bench.dk2, bench.clock.now(), {.light_leds = true}).value();
    auto source = camera::TrackerCamera::open(bench.device, camera::Sync::headset).value();
    EXPECT_TRUE(source.calibrated());
    camera::ExposurePairing pairing(std::chrono::microseconds(350));
    camera::LedTracker tracker(bench.leds, source.lens());
    PoseErrors out;
    std::optional<RigidPose> last;
    for (double t = 0.01; t < seconds; t += 0.01) {
        bench.clock.sleep_until(at_s(t));
        while (std::holds_alternative<ImuSample>(imu.next(bench.clock.now()))) {
        }
        for (const auto& exposure : imu.take_exposures()) pairing.add(exposure);
        while (true) {
            auto next = source.next(bench.clock.now());
            const auto* frame = std::get_if<camera::CameraFrame>(&next);
            if (frame == nullptr) break;
            const auto shown = pairing.of(frame->stamp);
            if (!shown) continue;
            const auto pose = tracker.see(frame->image(), shown->number, shown->pattern, last);
            last = pose ? std::optional(pose->camera_from_imu) : std::nullopt;
            if (!pose) continue;
            if (out.first_pose_exposure < 0) out.first_pose_exposure = shown->number;
            const RigidPose truth = bench.truth(shown->middle);
            out.mm.push_back(
                1e3 * glm::distance(pose->camera_from_imu.translation_m, truth.translation_m));
            out.deg.push_back(
                glm::degrees(angle_between(pose->camera_from_imu.rotation, truth.rotation)));
        }
    }
    std::sort(out.mm.begin(), out.mm.end());
    std::sort(out.deg.begin(), out.deg.end());
    out.counts = tracker.counts();
    out.frames = source.counts();
    return out;
}

// Seen: 0.03 mm and 0.02 degrees at the median, 0.15 mm and 0.065 degrees at worst: grey levels.
TEST(CameraPose, IsTheTruthToTheGreyLevels) {
    for (const char* motion : {"still", "look", "stress"}) {
        const PoseErrors e = errors_of({.motion = motion});
        EXPECT_LT(e.quantile(e.mm, 0.5), 0.06) << motion;
        EXPECT_LT(e.quantile(e.mm, 1.0), 0.3) << motion;
        EXPECT_LT(e.quantile(e.deg, 1.0), 0.13) << motion;
        EXPECT_EQ(e.counts.poses, e.counts.images - 9) << motion;
        EXPECT_EQ(e.counts.acquired, 1u) << motion;
        EXPECT_EQ(e.counts.contradicted + e.frames.lost + e.frames.rejected, 0u) << motion;
    }
}

// Seen: 0.12 mm and 0.11 degrees at the median, 0.6 mm and 0.35 degrees at worst.
TEST(CameraPose, StandsTheSensorsNoiseAndLampsInTheRoom) {
    for (const char* motion : {"still", "look", "stress"}) {
        const PoseErrors e = errors_of({.motion = motion, .faults = {.noise = 1, .spots = 8}});
        EXPECT_LT(e.quantile(e.mm, 0.5), 0.25) << motion;
        EXPECT_LT(e.quantile(e.mm, 1.0), 1.2) << motion;
        EXPECT_LT(e.quantile(e.deg, 0.5), 0.2) << motion;
        EXPECT_LT(e.quantile(e.deg, 1.0), 0.7) << motion;
        EXPECT_GE(e.counts.poses, e.counts.images - 9) << motion;
    }
}

// Ten frames show all ten bits; a pose comes of the tenth.
TEST(CameraPose, ComesWithTheTenthFlash) {
    EXPECT_EQ(errors_of({}, 0.5).first_pose_exposure, 9);
}

TEST(CameraPose, ComesOfYuyvFramesOfHalfTheWidthToo) {
    const PoseErrors grey = errors_of({.motion = "look"}, 1.0);
    const PoseErrors yuyv = errors_of({.motion = "look", .yuyv = true}, 1.0);
    EXPECT_EQ(grey.mm, yuyv.mm);
    EXPECT_EQ(grey.deg, yuyv.deg);
}

TEST(CameraPose, KnowsTheLensOfTheCalibrationMemory) {
    const camera::Lens odd{.fx_px = 693,
                           .fy_px = 691,
                           .cx_px = 360,
                           .cy_px = 250,
                           .k1 = -0.33,
                           .k2 = 0.12,
                           .p1 = 0.001,
                           .p2 = -0.0005,
                           .k3 = -0.01};
    const PoseErrors e = errors_of({.motion = "look", .lens = odd});
    EXPECT_LT(e.quantile(e.mm, 1.0), 0.3);
    EXPECT_LT(e.quantile(e.deg, 1.0), 0.13);
    EXPECT_GT(e.counts.poses, 160u);
}

TEST(CameraPose, IsFoundAgainAfterCoverAndLosses) {
    const PoseErrors e = errors_of(
        {.motion = "look", .faults = {.dropout = 0.1, .occlude_at = 1.0, .occlude_for = 0.5}}, 4.0);
    EXPECT_EQ(e.counts.acquired, 2u);
    EXPECT_GT(e.frames.lost, 10u);
    EXPECT_GT(e.counts.poses, 150u);
    EXPECT_LT(e.quantile(e.mm, 1.0), 0.5);
}

// The distance is known by how far the LEDs lie apart, and far away spots that run together are
// left out besides. Seen: at worst 0.05, 0.5 and 5.7 mm.
TEST(CameraPose, IsFoundFromNearAndFar) {
    for (const double distance_m : {0.4, 1.5, 2.0}) {
        RigidPose place = usual_camera_place();
        place.translation_m.z = -distance_m;
        const PoseErrors e = errors_of({.motion = "look", .world_from_camera = place}, 1.0);
        EXPECT_GT(e.counts.poses, 40u) << distance_m;
        EXPECT_LT(e.quantile(e.mm, 1.0), 0.3 + std::pow(distance_m, 3)) << distance_m;
    }
}

}  // namespace
}  // namespace foverig
