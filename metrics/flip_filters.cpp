#include "metrics/flip_filters.h"

#include <cmath>
#include <numbers>

namespace foverig::metrics {
namespace {

constexpr double kPi = std::numbers::pi;

/// Table 1 of the paper: a sum of Gaussians in cycles per degree, as filters of degrees.
struct Gaussian {
    double a, b;
    double weight() const { return a * std::sqrt(kPi / b); }
};
constexpr Gaussian kAchromatic{1.0, 0.0047}, kRedGreen{1.0, 0.0053};
constexpr Gaussian kBlueYellow1{34.1, 0.04}, kBlueYellow2{13.5, 0.025};
constexpr double kFeatureWidth_deg = 0.082;

std::vector<double> gaussian_taps(double per_squared_px, int reach) {
    std::vector<double> taps;
    for (int i = -reach; i <= reach; ++i) taps.push_back(std::exp(-per_squared_px * i * i));
    return taps;
}

double sum_of(const std::vector<double>& taps) {
    double sum = 0.0;
    for (const double t : taps) sum += t;
    return sum;
}

Taps scaled(const std::vector<double>& taps, double factor) {
    Taps result;
    for (const double t : taps)  // a denormal weighs nothing and costs a hundred cycles
        result.push_back(factor * t < 1.0e-12 ? 0.0F : static_cast<float>(factor * t));
    return result;
}

/// Positive taps sum to 1, negative ones to -1.
Taps balanced(const std::vector<double>& taps) {
    double positive = 0.0;
    double negative = 0.0;
    for (const double t : taps) (t > 0.0 ? positive : negative) += std::abs(t);
    Taps result;
    for (const double t : taps)
        result.push_back(static_cast<float>(t / (t > 0.0 ? positive : negative)));
    return result;
}

}  // namespace

FlipFilters::FlipFilters(double pixels_per_degree) {
    const double p = pixels_per_degree;
    // One reach for all channels: three standard deviations of the widest.
    const int reach = static_cast<int>(std::ceil(3.0 * std::sqrt(0.04 / (2.0 * kPi * kPi)) * p));
    const auto taps_of = [&](const Gaussian& g) {
        return gaussian_taps(kPi * kPi / (g.b * p * p), reach);
    };
    const auto normalised = [](const std::vector<double>& taps) {
        return scaled(taps, 1.0 / sum_of(taps));
    };
    achromatic = normalised(taps_of(kAchromatic));
    red_green = normalised(taps_of(kRedGreen));
    const auto first = taps_of(kBlueYellow1);
    const auto second = taps_of(kBlueYellow2);
    const double total = kBlueYellow1.weight() * std::pow(sum_of(first), 2) +
                         kBlueYellow2.weight() * std::pow(sum_of(second), 2);
    blue_yellow_1 = scaled(first, std::sqrt(kBlueYellow1.weight() / total));
    blue_yellow_2 = scaled(second, std::sqrt(kBlueYellow2.weight() / total));

    const double sigma_px = 0.5 * kFeatureWidth_deg * p;
    const int feature_reach = static_cast<int>(std::ceil(3.0 * sigma_px));
    const auto gaussian = gaussian_taps(0.5 / (sigma_px * sigma_px), feature_reach);
    auto first_derivative = gaussian;
    auto second_derivative = gaussian;
    for (int i = -feature_reach; i <= feature_reach; ++i) {
        const auto k = static_cast<std::size_t>(i + feature_reach);
        first_derivative[k] *= -i;
        second_derivative[k] *= i * i / (sigma_px * sigma_px) - 1.0;
    }
    smooth = normalised(gaussian);
    edge = balanced(first_derivative);
    point = balanced(second_derivative);
    margin = std::max(reach, feature_reach);
}

}  // namespace foverig::metrics
