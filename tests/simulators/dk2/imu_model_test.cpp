#include "simulators/dk2/imu_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "simulators/motion/look_head.h"
#include "simulators/motion/simple_heads.h"

namespace foverig {
namespace {

Dk2Faults fault(const char* kind, double value) {
    FaultSettings faults;
    EXPECT_TRUE(set_fault(faults, "dk2", kind, value)) << kind;
    return faults.dk2;
}

std::vector<dk2::InertialSlot> at_rest(const Dk2Faults& faults, int samples) {
    ImuModel imu(faults, 5);
    const motion::HeadState still = motion::StillHead().at(0.0);
    std::vector<dk2::InertialSlot> slots;
    for (int i = 0; i < samples; ++i) slots.push_back(imu.measure(still, i, 1e-3 * i));
    return slots;
}

struct Moments {
    double mean = 0, deviation = 0;
};

Moments moments(const std::vector<dk2::InertialSlot>& slots,
                const std::function<double(const dk2::InertialSlot&)>& value) {
    double sum = 0, square = 0;
    for (const auto& s : slots) sum += value(s);
    const double mean = sum / static_cast<double>(slots.size());
    for (const auto& s : slots) square += (value(s) - mean) * (value(s) - mean);
    return {mean, std::sqrt(square / static_cast<double>(slots.size()))};
}

TEST(ImuModel, WithoutFaultsIsTheTruthInReportUnits) {
    ImuModel imu({}, 1);
    const motion::LookHead look(2);
    for (int i = 0; i < 3000; ++i) {
        const double t = 1e-3 * i;
        const motion::HeadState head = look.at(t);
        const auto slot = imu.measure(head, i, t);
        const dvec3 gyro_error = dk2::to_si(slot.gyro) - head.angular_velocity_rad_s;
        const dvec3 accel_error =
            dk2::to_si(slot.accel) - motion::specific_force(head, kImuFromEyes_m, kGravity_m_s2);
        ASSERT_LE(glm::length(gyro_error), 0.5e-4 * std::sqrt(3.0) + 1e-12);
        ASSERT_LE(glm::length(accel_error), 0.5e-4 * std::sqrt(3.0) + 1e-12);
    }
}

// DEVICES.md 6.2: 31 report units of gyro noise and 990 of accelerometer noise a sample at 1 kHz.
TEST(ImuModel, NoiseHasTheDocumentedSigma) {
    const auto slots = at_rest(fault("noise", 1.0), 20000);
    EXPECT_NEAR(moments(slots, [](const auto& s) { return s.gyro.y; }).deviation, 31.0, 0.6);
    EXPECT_NEAR(moments(slots, [](const auto& s) { return s.gyro.y; }).mean, 0.0, 1.0);
    EXPECT_NEAR(moments(slots, [](const auto& s) { return s.accel.x; }).deviation, 990.0, 20.0);
    EXPECT_NEAR(moments(slots, [](const auto& s) { return s.accel.y; }).mean, 98066.5, 30.0);
}

TEST(ImuModel, NoiseIsWhite) {
    const auto slots = at_rest(fault("noise", 1.0), 20000);
    double lag = 0, power = 0;
    for (std::size_t i = 0; i + 1 < slots.size(); ++i) {
        lag += static_cast<double>(slots[i].gyro.x) * slots[i + 1].gyro.x;
        power += static_cast<double>(slots[i].gyro.x) * slots[i].gyro.x;
    }
    EXPECT_NEAR(lag / power, 0.0, 4.0 / std::sqrt(20000.0));
}

TEST(ImuModel, BiasIsConstantAndBounded) {
    const auto slots = at_rest(fault("bias", 5.0), 100);
    const double limit = 1e4 * glm::radians(5.0);
    EXPECT_EQ(slots.front(), slots.back());
    EXPECT_NE(slots.front().gyro, dk2::Triple{});
    EXPECT_LE(std::abs(slots.front().gyro.x), limit);
    EXPECT_EQ(slots.front().accel, at_rest({}, 1).front().accel);
}

TEST(ImuModel, ScaleTurnsAndStretchesWithinItsLimit) {
    ImuModel imu(fault("scale", 3.0), 5);
    motion::HeadState turning;
    turning.angular_velocity_rad_s = {0.0, 5.0, 0.0};
    const dvec3 gyro = dk2::to_si(imu.measure(turning, 0, 0.0).gyro);
    EXPECT_NEAR(gyro.y, 5.0, 0.15 + 1e-4);
    EXPECT_NE(gyro.y, 5.0);
    EXPECT_NEAR(gyro.x, 0.0, 0.15 + 1e-4);
    EXPECT_GT(std::abs(gyro.x), 1e-4);
}

TEST(ImuModel, TemperatureDriftFollowsTheWarmUp) {
    ImuModel imu(fault("temperature_drift", 0.1), 5);
    EXPECT_NEAR(imu.temperature_c(0.0), 25.0, 1e-9);
    EXPECT_NEAR(imu.temperature_c(480.0), 38.0 - 13.0 / std::exp(1.0), 1e-9);
    const auto still = motion::StillHead().at(0.0);
    EXPECT_EQ(imu.measure(still, 0, 0.0).gyro, dk2::Triple{});
    const double drift_deg_s = 0.1 * 13.0 * (1.0 - std::exp(-1.0));
    EXPECT_NEAR(std::abs(imu.measure(still, 1, 480.0).gyro.z), 1e4 * glm::radians(drift_deg_s),
                1.0);
}

TEST(ImuModel, RandomWalkGrowsWithTheSquareRootOfTime) {
    double square = 0.0;
    constexpr int kRuns = 300, kSamples = 400;
    for (int run = 0; run < kRuns; ++run) {
        ImuModel imu(fault("random_walk", 0.5), static_cast<std::uint64_t>(run));
        dk2::InertialSlot last;
        for (int i = 0; i < kSamples; ++i)
            last = imu.measure(motion::StillHead().at(0.0), i, 1e-3 * i);
        square += std::pow(1e-4 * last.gyro.x, 2);
    }
    const double expected = 0.5 * std::sqrt(1e-3 * kSamples);
    EXPECT_NEAR(std::sqrt(square / kRuns), expected, 0.12 * expected);
}

TEST(ImuModel, LowPassHasItsHalfPowerPoint) {
    // A one-pole filter passes a sine at a quarter of its corner nearly whole and delays it.
    const auto gain_at = [](double hz) {
        ImuModel imu(fault("low_pass", 50.0), 1);
        double peak = 0.0;
        for (int i = 0; i < 2000; ++i) {
            motion::HeadState head;
            head.angular_velocity_rad_s.x = std::sin(2.0 * M_PI * hz * 1e-3 * i);
            const double y = dk2::to_si(imu.measure(head, i, 0.0).gyro).x;
            if (i > 1000) peak = std::max(peak, y);
        }
        return peak;
    };
    EXPECT_NEAR(gain_at(50.0), std::sqrt(0.5), 0.03);
    EXPECT_NEAR(gain_at(12.5), 0.970, 0.01);
}

TEST(ImuModel, QuantisesToTheChipsStepsAndClips) {
    ImuModel imu(fault("quantise", 1.0), 1);
    motion::HeadState head;
    head.angular_velocity_rad_s = {glm::radians(0.0610 * 5.4), glm::radians(2500.0), 0.0};
    const auto slot = imu.measure(head, 0, 0.0);
    EXPECT_NEAR(slot.gyro.x, 5 * 10.64, 0.6);  // 10.64 report units a step
    EXPECT_NEAR(slot.gyro.y, 1e4 * glm::radians(2000.0), 6.0);
    EXPECT_NEAR(std::fmod(slot.accel.y, 11.971), 0.0, 11.971);
    // The extreme motion's knock of 6 g runs into the 4 g range.
    ImuModel knocked(fault("quantise", 1.0), 1);
    const motion::ShakeHead shake(motion::ShakeHead::extreme());
    EXPECT_EQ(std::abs(knocked.measure(shake.at(5.0), 0, 0.0).accel.x), 392266);
}

}  // namespace
}  // namespace foverig
