#include "simulators/motion/band_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace foverig::motion {
namespace {

/// Power of the rate at a frequency, by a Hann-windowed Fourier sum over 100 s.
double rate_power(const BandNoise& noise, double hz) {
    constexpr double kStep_s = 0.02, kLength_s = 100.0;
    std::complex<double> sum = 0.0;
    for (double t = 0.0; t < kLength_s; t += kStep_s) {
        const double window = 1.0 - std::cos(2.0 * std::numbers::pi * t / kLength_s);
        sum += window * noise.at(t).rate * std::polar(1.0, -2.0 * std::numbers::pi * hz * t);
    }
    return std::norm(sum * kStep_s) / kLength_s;
}

TEST(BandNoise, HasTheRateAskedFor) {
    const BandNoise noise(Draws(1, 1), 0.2, 3.0, 2.0, 24);
    double square = 0.0;
    int n = 0;
    for (double t = 0.0; t < 500.0; t += 0.013, ++n) square += std::pow(noise.at(t).rate, 2);
    EXPECT_NEAR(std::sqrt(square / n), 2.0, 0.04);
}

TEST(BandNoise, LiesWithinItsBand) {
    const BandNoise noise(Draws(1, 1), 0.2, 3.0, 2.0, 24);
    double inside = 0.0, outside = 0.0;
    for (double hz = 0.25; hz < 2.95; hz += 0.01) inside += rate_power(noise, hz) / 270.0;
    for (const double hz : {0.1, 0.15, 3.1, 4.0, 7.0, 12.0}) outside += rate_power(noise, hz) / 6.0;
    EXPECT_LT(outside, 1e-4 * inside);
}

TEST(BandNoise, DerivativesMatchDifferences) {
    const BandNoise noise(Draws(9, 1), 0.2, 3.0, 2.0, 24);
    constexpr double kH = 1e-4;
    for (double t = 0.0; t < 5.0; t += 0.37) {
        const double before = noise.at(t - kH).value, at = noise.at(t).value,
                     after = noise.at(t + kH).value;
        EXPECT_NEAR(noise.at(t).rate, (after - before) / (2.0 * kH), 1e-5);
        EXPECT_NEAR(noise.at(t).acceleration, (after - 2.0 * at + before) / (kH * kH), 1e-4);
    }
}

}  // namespace
}  // namespace foverig::motion
