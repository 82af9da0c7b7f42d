#include "simulators/gaze/tracker_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "simulators/motion/scan_eye.h"

namespace foverig {
namespace {

using motion::StillEye;

GazeFaults fault(const char* kind, double value) {
    FaultSettings faults;
    EXPECT_TRUE(set_fault(faults, "gaze", kind, value)) << kind;
    return faults.gaze;
}

dvec3 from_wire(const gaze::Vec3f& v) {
    return {-v[0], v[1], -v[2]};
}

struct Measured {
    std::vector<dvec2> left, right, combined;  // degrees
};

Measured measure(const motion::EyeMotion& eyes, const GazeFaults& faults, int n,
                 std::uint64_t seed = 1, bool low_pass = false) {
    TrackerModel tracker(eyes, faults, seed);
    Measured m;
    for (int i = 0; i < n; ++i) {
        const auto frame = tracker.measure(i / 60.0, 60.0, low_pass, std::nullopt);
        m.left.push_back(motion::gaze_of(from_wire(frame.left.direction)));
        m.right.push_back(motion::gaze_of(from_wire(frame.right.direction)));
        m.combined.push_back(motion::gaze_of(from_wire(frame.direction)));
    }
    return m;
}

/// Over one axis: standard deviation, sample-to-sample root mean square, lag-1 autocorrelation.
struct Precision {
    double std_deg = 0, rms_s2s_deg = 0, lag1 = 0;
};
Precision precision(const std::vector<dvec2>& gaze, int axis) {
    double mean = 0, square = 0, step = 0, product = 0;
    const auto n = static_cast<double>(gaze.size());
    for (const auto& g : gaze) mean += g[axis] / n;
    for (std::size_t i = 0; i < gaze.size(); ++i) {
        square += std::pow(gaze[i][axis] - mean, 2);
        if (i == 0) continue;
        step += std::pow(gaze[i][axis] - gaze[i - 1][axis], 2);
        product += (gaze[i][axis] - mean) * (gaze[i - 1][axis] - mean);
    }
    return {std::sqrt(square / n), std::sqrt(step / (n - 1.0)), product / square};
}

TEST(TrackerModel, WithoutFaultsIsTheTruth) {
    const motion::ScanEye scan(3);
    TrackerModel tracker(scan, {}, 1);
    for (int i = 0; i < 2000; ++i) {
        const double t = i / 60.0;
        const auto frame = tracker.measure(t, 60.0, false, std::nullopt);
        EXPECT_LT(glm::distance(from_wire(frame.direction), scan.at(t).direction), 1e-7);
        EXPECT_EQ(frame.status, 0x000F);
        EXPECT_EQ(frame.left.state, gaze::EyeState::tracked);
        EXPECT_NEAR(glm::length(from_wire(frame.left.direction)), 1.0, 1e-6);
    }
}

// DEVICES.md 5.3: the vergence angle is 3.64 degrees at 1 m for 63.5 mm; here with our 64 mm.
TEST(TrackerGeometry, EyesConvergeOnTheirTarget) {
    const motion::EyeState ahead{.vergence_m = 1.0};
    const double angle = glm::degrees(
        std::acos(glm::dot(eye_direction(Side::left, ahead), eye_direction(Side::right, ahead))));
    EXPECT_NEAR(angle, glm::degrees(2.0 * std::atan(0.064 / 2.0)), 1e-9);
    EXPECT_GT(eye_direction(Side::left, ahead).x, 0.0);
}

// DEVICES.md 2.2: the panel's edges are the frustum's tangents, its centre of view is lens centre.
TEST(TrackerGeometry, PointOfRegardSpansTheFrustum) {
    EXPECT_NEAR(por_in_eye_px(Side::left, glm::normalize(dvec3(-1.058657, 1.331603, -1))).x, 0.0,
                1e-9);
    EXPECT_NEAR(por_in_eye_px(Side::left, glm::normalize(dvec3(-1.058657, 1.331603, -1))).y, 0.0,
                1e-9);
    EXPECT_NEAR(por_in_eye_px(Side::left, glm::normalize(dvec3(1.092368, -1.331603, -1))).x, 960.0,
                1e-9);
    EXPECT_NEAR(por_in_eye_px(Side::right, glm::normalize(dvec3(1.058657, 0, -1))).x, 960.0, 1e-9);
    const dvec2 left = por_in_eye_px(Side::left, dvec3(0, 0, -1));
    const dvec2 right = por_in_eye_px(Side::right, dvec3(0, 0, -1));
    EXPECT_NEAR(left.x + right.x, 960.0, 1e-9);  // mirrored
    EXPECT_EQ(left.y, 540.0);
}

// DEVICES.md 5.5: STD 0.12 degrees per eye at the centre, lag-1 autocorrelation 0.3, RMS-S2S
// 0.142; combined 0.75 of it; and the identity RMS-S2S^2 = 2 STD^2 (1 - lag1).
TEST(TrackerModel, NoiseHasTheDocumentedPrecision) {
    const StillEye still;
    const auto m = measure(still, fault("noise", 0.12), 40000);
    for (const int axis : {0, 1}) {
        const Precision left = precision(m.left, axis);
        EXPECT_NEAR(left.std_deg, 0.12, 0.002);
        EXPECT_NEAR(left.lag1, 0.3, 0.015);
        EXPECT_NEAR(left.rms_s2s_deg, 0.142, 0.002);
        EXPECT_NEAR(std::pow(left.rms_s2s_deg, 2),
                    2.0 * std::pow(left.std_deg, 2) * (1.0 - left.lag1), 1e-5);
        EXPECT_NEAR(precision(m.combined, axis).std_deg, 0.75 * 0.12, 0.002);
    }
}

TEST(TrackerModel, NoiseGrowsWithEccentricity) {
    const auto m = measure(StillEye({0.0, 20.0}), fault("noise", 0.12), 20000);
    EXPECT_NEAR(
        precision(m.left, 0).std_deg * std::cos(glm::radians(20.0)) / std::cos(glm::radians(20.0)),
        0.24, 0.005);
}

TEST(TrackerModel, OffsetsAreConstantAndDrawnPerCalibration) {
    double square = 0.0;
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
        const auto m = measure(StillEye(), fault("offset", 0.4), 2, seed);
        EXPECT_EQ(m.left[0], m.left[1]);
        square += m.left[0].y * m.left[0].y;
    }
    EXPECT_NEAR(std::sqrt(square / 500.0), 0.4, 4.0 * 0.4 / std::sqrt(1000.0));
}

TEST(TrackerModel, CrosstalkIsQuadraticAndSlipLinear) {
    const auto at = [](double x) {
        return measure(StillEye({x, 0.0}), fault("crosstalk", 0.5), 1).combined[0];
    };
    EXPECT_NEAR(at(20.0).y, 0.5, 0.01);
    EXPECT_NEAR(at(-20.0).y, 0.5, 0.01);
    EXPECT_NEAR(at(10.0).y, 0.125, 0.005);
    EXPECT_NEAR(at(20.0).x, 20.0, 0.001);
    const auto slipping = measure(StillEye(), fault("slip", 0.1), 3601).combined;
    EXPECT_NEAR(glm::distance(slipping.front(), slipping.back()), 0.1, 1e-5);
}

TEST(TrackerModel, BlinksGiveOneWeakSampleEachSideAndNoneBetween) {
    const StillEye still;
    TrackerModel tracker(still, fault("blink", 14.0), 2);
    std::vector<gaze::SampleFrame> frames;
    for (int i = 0; i < 36000; ++i)
        frames.push_back(tracker.measure(i / 60.0, 60.0, false, std::nullopt));
    int blinks = 0, weak = 0;
    for (std::size_t i = 1; i + 1 < frames.size(); ++i) {
        const auto& eye = frames[i].left;
        if (eye.state == gaze::EyeState::invalid) {
            EXPECT_LT(eye.openness, 0.35f);
            EXPECT_EQ(frames[i].status, 0x0030);  // both blink, nothing valid
            EXPECT_TRUE(std::isnan(eye.direction[0]));
            EXPECT_EQ(eye.cause, gaze::EyeCause::blink);
            blinks += frames[i - 1].left.state != gaze::EyeState::invalid ? 1 : 0;
        } else if (eye.state == gaze::EyeState::compensated) {
            ++weak;
            EXPECT_EQ(eye.confidence, 0.5f);
            EXPECT_NEAR(motion::gaze_of(from_wire(eye.direction)).y, -2.0, 1e-3);
            EXPECT_TRUE(frames[i - 1].left.state == gaze::EyeState::invalid ||
                        frames[i + 1].left.state == gaze::EyeState::invalid);
        }
    }
    EXPECT_NEAR(blinks, 140, 4 * 12);
    EXPECT_GT(weak, blinks);  // the lid may be fully open one sample from the invalid ones
    EXPECT_LE(weak, 2 * blinks);
}

// DEVICES.md 4.3: the binocular signal is a low-pass filtered version, not fit for saccades.
TEST(TrackerModel, LowPassSpreadsAJump) {
    class Jump final : public motion::EyeMotion {
        motion::EyeState at(double t_s) const override {
            return {.direction = motion::direction_of({t_s < 0.5 ? 0.0 : 10.0, 0.0})};
        }
    };
    const auto m = measure(Jump(), {}, 120, 1, true);
    const double gain = 1.0 - std::exp(-2.0 * M_PI * 8.0 / 60.0);
    EXPECT_NEAR(m.combined[30].x, 10.0 * gain, 0.05);
    EXPECT_NEAR(m.combined[119].x, 10.0, 1e-3);
}

}  // namespace
}  // namespace foverig
