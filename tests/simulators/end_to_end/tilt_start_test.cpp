// Tilt by the inertial sensor alone while the gyro's offset is being learnt, from the headset's
// bytes: issue 4's bar of 0.5 degrees holds in the first half minute too, however the head moves.
#include <gtest/gtest.h>

#include <cmath>

#include "devices/dk2/imu_source.h"
#include "devices/fusion/head_fusion.h"
#include "simulators/dk2/simulated_dk2.h"
#include "simulators/motion/catalog.h"

namespace foverig {
namespace {

/// Those of the hour's bench.
const Dk2Faults kUsual{.noise = 1,
                       .low_pass = 250,
                       .quantise = 1,
                       .bias = 0.2,
                       .temperature_drift = 0.01,
                       .random_walk = 3e-5,
                       .clock_drift = 50,
                       .host_delay = 1.0};

/// From 0.1 s on, when the first look at gravity is over.
double worst_tilt_deg(const char* motion, std::uint64_t seed) {
    ManualClock clock;
    const auto head = std::move(motion::make_head(motion, seed)).value();
    SimulatedDk2 device(clock, *head, {.faults = kUsual, .seed = seed});
    auto source = std::move(dk2::Dk2ImuSource::open(device, clock.now())).value();
    HeadFusion fusion;
    double worst_deg = 0;
    for (double t_s = 0.01; t_s < 30.0; t_s += 0.01) {
        clock.sleep_until(HostTime(from_seconds(t_s)));
        while (true) {
            const auto next = source.next(clock.now());
            const auto* sample = std::get_if<ImuSample>(&next);
            if (sample == nullptr) break;
            fusion.add(*sample);
        }
        if (t_s < 0.1) continue;
        const dvec3 up(0, 1, 0);
        const dvec3 told = glm::conjugate(fusion.at(clock.now()).world_from_head) * up;
        const dvec3 truth = glm::conjugate(head->at(t_s).world_from_head) * up;
        worst_deg = std::max(
            worst_deg,
            glm::degrees(std::atan2(glm::length(glm::cross(told, truth)), glm::dot(told, truth))));
    }
    return worst_deg;
}

class TiltStart : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Motions, TiltStart,
                         testing::Values("still", "look", "stress", "extreme", "step"),
                         [](const auto& motion) { return std::string(motion.param); });

// Seen of eight seeds: at worst 0.15, 0.23, 0.22, 0.31 and 0.15 degrees. With the end's gains alone
// they were 0.51, 0.57, 0.64, 0.65 and 0.54.
TEST_P(TiltStart, HoldsTheHoursBar) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed)
        EXPECT_LT(worst_tilt_deg(GetParam(), seed), 0.5) << seed;
}

}  // namespace
}  // namespace foverig
