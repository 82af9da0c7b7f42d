#include "metrics/contrast_sensitivity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace foverig::metrics {
namespace {

using Triple = std::array<double, 3>;

/// Of one of the three mechanisms that see a grating: black and white, red and green, violet and
/// yellow. Peaks depend on the luminance that the long and middle cones respond to.
struct Mechanism {
    double sensitivity = 0.0, frequency = 0.0;  ///< at the peak
    double bandwidth = 0.0, area_exponent = 0.0, area = 0.0;
    bool low_pass = false;
};

double of_luminance(const Triple& p, double l) {
    return p[0] * std::pow(1.0 + p[1] / l, -p[2]);
}

std::array<Mechanism, 3> mechanisms_at(double l) {
    const double bright = 1.0 - std::pow(1.0 + 895943.0 / l, -7.77919e-5);
    return {
        {{of_luminance({356404.0, 6.2726, 0.320031}, l) * bright,
          of_luminance({2.3021, 3317.45, 0.186215}, l), 1.07516, 1.1107, 52.9768, false},
         {of_luminance({423.978, 15.4032, 0.50343}, l), 0.122699, 2.70669, 1.72903, 1.38437, true},
         {of_luminance({11811.9, 196.342, 0.339396}, l), 7.1099e-8, 5.3416, 1.47263, 0.282573,
          true}}};
}

double sensitivity_of(const Mechanism& m, double cycles_per_deg, double area_deg2) {
    const double octaves = std::log10(cycles_per_deg) - std::log10(m.frequency);
    double peak = m.sensitivity;
    if (!m.low_pass || cycles_per_deg > m.frequency)
        peak *= std::pow(10.0, -octaves * octaves / (0.5 * std::exp2(m.bandwidth)));
    const double seen = std::pow(area_deg2, m.area_exponent) * cycles_per_deg * cycles_per_deg;
    return peak * std::sqrt(seen / (m.area + 0.65 * area_deg2 + seen));
}

/// Of a grating of black and white on D65 that shows 1.5 cycles (a disc of that radius).
double still_sensitivity(double cycles_per_deg, double background_cd_m2) {
    constexpr Triple kWhite{0.73473566, 0.31629043, 0.02082139};  // LMS of 1 cd/m2
    constexpr Triple kStimulus{0.698, 0.302, 0.019613};
    constexpr std::array<Triple, 3> kOpponent{
        {{1.0, 0.256197, 6.42e-7}, {1.0, -0.933541, 0.00373304}, {-0.00130319, -1.1504, 1.0}}};
    const double area_deg2 = std::numbers::pi * std::pow(1.5 / cycles_per_deg, 2.0);
    const auto mechanisms = mechanisms_at((kWhite[0] + kWhite[1]) * background_cd_m2);
    double squares = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        double contrast = 0.0;
        for (std::size_t c = 0; c < 3; ++c)
            contrast += kOpponent[i][c] * kStimulus[c] / (background_cd_m2 * kWhite[c]);
        const double seen =
            std::abs(contrast) * sensitivity_of(mechanisms[i], cycles_per_deg, area_deg2);
        squares += seen * seen;
    }
    double cones = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
        const double threshold = kStimulus[c] / std::sqrt(squares) / (background_cd_m2 * kWhite[c]);
        cones += threshold * threshold;
    }
    return std::sqrt(3.0 / cones);
}

/// Daly's fit of Kelly's measurements: of gratings that move so fast that they change at that rate.
double moving_sensitivity(double cycles_per_deg, double temporal_hz) {
    const double speed_deg_s = std::max(temporal_hz / cycles_per_deg, 0.1);
    const double scaled = 0.7986 * speed_deg_s;
    const double k = 6.1 + 7.3 * std::pow(std::abs(std::log10(scaled / 3.0)), 3.0);
    const double highest = 45.9 / (scaled + 2.0);
    const double frequency = 0.8404 * 2.0 * std::numbers::pi * cycles_per_deg;
    return k * 0.6329 * 0.8404 * scaled * frequency * frequency *
           std::exp(-2.0 * frequency / highest);
}

// The authors' program has tables of this formula that lie so much lower.
constexpr double kTablesByFormula = 0.9942;

constexpr int kFrequencies = 261, kBackgrounds = 81;  // 20 and 4 an octave
constexpr float kFirstFrequency = -6.0F, kFrequenciesPerOctave = 20.0F;
constexpr float kFirstBackground = -6.643856F, kBackgroundsPerOctave = 4.0F;

/// Between which two entries, and where between them.
struct Entry {
    int index = 0;
    float share = 0.0F;
};

Entry entry_of(float x, float first, float per_octave, int count) {
    const float at = std::clamp((x - first) * per_octave, 0.0F, static_cast<float>(count - 1));
    const int index = std::min(static_cast<int>(at), count - 2);
    return {index, at - static_cast<float>(index)};
}

}  // namespace

double contrast_sensitivity(double cycles_per_deg, double temporal_hz, double background_cd_m2,
                            double eccentricity_deg) {
    const double foveal =
        cycles_per_deg *
        std::exp2(double{log2_cortical_demagnification(static_cast<float>(eccentricity_deg))});
    return kTablesByFormula * still_sensitivity(foveal, background_cd_m2) *
           moving_sensitivity(foveal, temporal_hz) / (moving_sensitivity(foveal, 0.0) + 1.0e-5);
}

SensitivityTable::SensitivityTable(double temporal_hz) {
    log2_sensitivity_.reserve(std::size_t{kFrequencies} * kBackgrounds);
    for (int f = 0; f < kFrequencies; ++f)
        for (int b = 0; b < kBackgrounds; ++b) {
            const double s = contrast_sensitivity(
                std::exp2(double{kFirstFrequency} + f / double{kFrequenciesPerOctave}), temporal_hz,
                std::exp2(double{kFirstBackground} + b / double{kBackgroundsPerOctave}), 0.0);
            log2_sensitivity_.push_back(static_cast<float>(std::log2(std::max(s, 1.0e-4))));
        }
}

float SensitivityTable::at(float log2_cycles_per_deg, float log2_background_cd_m2) const {
    const Entry f =
        entry_of(log2_cycles_per_deg, kFirstFrequency, kFrequenciesPerOctave, kFrequencies);
    const Entry b =
        entry_of(log2_background_cd_m2, kFirstBackground, kBackgroundsPerOctave, kBackgrounds);
    const float* low =
        &log2_sensitivity_[static_cast<std::size_t>(f.index * kBackgrounds + b.index)];
    const float* high = low + kBackgrounds;
    const float at_low = low[0] + b.share * (low[1] - low[0]);
    const float at_high = high[0] + b.share * (high[1] - high[0]);
    return exp2_of(at_low + f.share * (at_high - at_low));
}

}  // namespace foverig::metrics
