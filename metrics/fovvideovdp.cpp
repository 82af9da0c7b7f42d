#include "metrics/fovvideovdp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "metrics/display_code.h"
#include "metrics/power.h"
#include "metrics/pyramid.h"
#include "metrics/rows.h"

namespace foverig::metrics {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr float kLog2OfTen = 3.32192809F;

// Fitted parameters of the paper's model, version 1.2 of its authors.
constexpr float kSensitivityCorrection = 16.2596F / 20.0F * kLog2OfTen;
constexpr float kMaskingGain = -0.973838F * kLog2OfTen;
constexpr float kDifferenceExponent = 2.4F, kHighestDifference = 1.0e4F;
constexpr std::array<float, 2> kMaskingExponents{2.43685F, 4.946F};
constexpr std::array<double, 2> kChannelWeights{1.0, 0.25};
constexpr float kPixelNorm = 1.52134F;
constexpr double kChannelNorm = 0.666092;
constexpr double kJodScale = 0.0161713, kJodExponent = 0.59156;
constexpr float kLowestBackground = 0.1F, kHighestContrast = 1000.0F;
constexpr std::array<double, 2> kTemporal_hz{0.0, 5.0};

Plane luminance_of(const Image& image, const ScreenLight& light) {
    const auto range = static_cast<float>(light.peak_cd_m2 - light.black_cd_m2);
    const auto black = static_cast<float>(light.black_cd_m2);
    Plane plane(image.width_px, image.height_px);
    for_rows(image.height_px, [&](int y) {
        const vec3* in = &image.at(0, y);
        float* out = plane.row(y);
        const auto shown = [](float v) { return std::min(std::max(v, 0.0F), 1.0F); };
        for (int x = 0; x < image.width_px; ++x)
            out[x] = black + range * (0.2126F * shown(in[x].x) + 0.7152F * shown(in[x].y) +
                                      0.0722F * shown(in[x].z));
    });
    return plane;
}

/// Pixels per degree straight ahead.
double resolution_of(const GazedView& view) {
    return 1.0 / (2.0 * kDegrees * std::atan(0.5 / view.focal_x_px));
}

/// The centre of a band, in cycles per degree.
double frequency_of(std::size_t band, double pixels_per_degree) {
    const double octaves = static_cast<double>(band) - 1.0;
    return 0.5 * pixels_per_degree * (band == 0 ? 1.0 : 0.3228 * std::exp2(-octaves));
}

std::size_t bands_of(int width_px, int height_px, double pixels_per_degree) {
    const int halvings = static_cast<int>(std::log2(std::min(width_px, height_px)));
    std::size_t bands = 1;
    while (static_cast<int>(bands) < halvings - 1 &&
           frequency_of(bands - 1, pixels_per_degree) > 0.5)
        ++bands;
    return bands;
}

/// A frame at half the size again and again; one more than there are bands.
std::vector<Plane> gaussian_pyramid(Plane frame, std::size_t bands) {
    std::vector<Plane> levels{std::move(frame)};
    while (levels.size() <= bands) levels.push_back(reduced(levels.back()));
    return levels;
}

/// By how much a band's frequency counts for more at each of its pixels, base 2 logarithms: a flat
/// screen has more pixels per degree away from its middle, and off the gaze the eye sees less.
class BandView {
  public:
    BandView(const GazedView& view, const Plane& level, std::size_t band, bool foveated)
        : foveated_(foveated) {
        const double step_px = std::exp2(static_cast<double>(band));
        const auto angle_deg = [](double at_px, double centre_px, double focal_px) {
            return static_cast<float>(kDegrees * std::atan((at_px - centre_px) / focal_px));
        };
        for (int x = 0; x < level.width_px; ++x)
            x_deg_.push_back(angle_deg((x + 0.5) * step_px, view.centre_x_px, view.focal_x_px));
        for (int y = 0; y < level.height_px; ++y)
            y_deg_.push_back(angle_deg((y + 0.5) * step_px, view.centre_y_px, view.focal_y_px));
        gaze_x_deg_ = angle_deg(view.gaze_x_px, view.centre_x_px, view.focal_x_px);
        gaze_y_deg_ = angle_deg(view.gaze_y_px, view.centre_y_px, view.focal_y_px);
    }

    float log2_factor(int x, int y) const {
        if (!foveated_) return 0.0F;
        const float x_deg = x_deg_[static_cast<std::size_t>(x)];
        const float y_deg = y_deg_[static_cast<std::size_t>(y)];
        const float off_axis_deg = std::sqrt(x_deg * x_deg + y_deg * y_deg);
        const float dx_deg = x_deg - gaze_x_deg_;
        const float dy_deg = y_deg - gaze_y_deg_;
        const float off_gaze_deg = std::sqrt(dx_deg * dx_deg + dy_deg * dy_deg);
        const float cosine = std::cos(off_axis_deg * static_cast<float>(1.0 / kDegrees));
        return -2.0F * log2_of(std::max(cosine, 1.0e-3F)) +
               log2_cortical_demagnification(off_gaze_deg);
    }

  private:
    bool foveated_;
    std::vector<float> x_deg_, y_deg_;
    float gaze_x_deg_ = 0.0F, gaze_y_deg_ = 0.0F;
};

/// What two contrasts differ by in what is seen of them; the fainter one masks.
float visible_difference(float test, float reference, float sensitivity, float masking_exponent) {
    const float t = test * sensitivity;
    const float r = reference * sensitivity;
    const float mask = exp2_of(kMaskingGain) * std::min(std::abs(t), std::abs(r));
    return std::min(kHighestDifference, power_of(std::abs(t - r), kDifferenceExponent) /
                                            (1.0F + power_of(mask, masking_exponent)));
}

double jod_of(double difference) {
    return 10.0 - kJodScale * std::pow(difference, kJodExponent);
}

}  // namespace

FovVideoVdp::FovVideoVdp(const ScreenLight& light, std::optional<double> frames_per_s)
    : light_(light), taps_{{1.0}} {
    if (frames_per_s) {
        const TemporalFilters filters(*frames_per_s);
        taps_ = {filters.sustained, filters.transient};
    }
    for (std::size_t channel = 0; channel < taps_.size(); ++channel)
        tables_.emplace_back(kTemporal_hz[channel]);
}

Plane FovVideoVdp::filtered(const std::deque<Plane>& frames,
                            const std::vector<double>& taps) const {
    Plane sum(frames[0].width_px, frames[0].height_px);
    for_rows(sum.height_px, [&](int y) {
        float* out = sum.row(y);
        for (std::size_t i = 0; i < taps.size(); ++i) {
            const float* in = frames[std::min(i, frames.size() - 1)].row(y);
            const auto tap = static_cast<float>(taps[i]);
            for (int x = 0; x < sum.width_px; ++x) out[x] += tap * in[x];
        }
    });
    return sum;
}

void FovVideoVdp::see(const Image& reference, const Image& test) {
    check_same_size(reference, test);
    if (!references_.empty())
        check_same_size({references_[0].width_px, references_[0].height_px, {}}, reference);
    references_.push_front(luminance_of(reference, light_));
    tests_.push_front(luminance_of(test, light_));
    if (references_.size() > taps_[0].size()) {
        references_.pop_back();
        tests_.pop_back();
    }
}

void FovVideoVdp::add(const Image& reference, const Image& test, const GazedView& view,
                      bool foveated) {
    see(reference, test);
    const std::size_t bands =
        bands_of(reference.width_px, reference.height_px, resolution_of(view));
    const auto levels = gaussian_pyramid(filtered(references_, taps_[0]), bands);
    std::vector<Plane> backgrounds;
    for (std::size_t band = 0; band < bands; ++band)
        backgrounds.push_back(
            expanded(levels[band + 1], levels[band].width_px, levels[band].height_px));
    double sum = 0.0;
    for (std::size_t channel = taps_.size(); channel-- > 0;)
        sum += std::pow(
            kChannelWeights[channel] * channel_difference(channel, backgrounds, view, foveated),
            kChannelNorm);
    newest_ = std::pow(sum, 1.0 / kChannelNorm);
    sum_ += newest_;
    ++frames_;
}

double FovVideoVdp::channel_difference(std::size_t channel, const std::vector<Plane>& backgrounds,
                                       const GazedView& view, bool foveated) {
    const auto references =
        gaussian_pyramid(filtered(references_, taps_[channel]), backgrounds.size());
    const auto tests = gaussian_pyramid(filtered(tests_, taps_[channel]), backgrounds.size());
    const double resolution = resolution_of(view);
    bands_.clear();
    double sum = 0.0;
    for (std::size_t band = 0; band < backgrounds.size(); ++band) {
        const Plane& reference = references[band];
        const Plane& test = tests[band];
        const Plane coarse_r =
            expanded(references[band + 1], reference.width_px, reference.height_px);
        const Plane coarse_t = expanded(tests[band + 1], test.width_px, test.height_px);
        const BandView band_view(view, reference, band, foveated);
        const auto frequency = static_cast<float>(std::log2(frequency_of(band, resolution)));
        const float gain = band == 0 ? 1.0F : 2.0F;
        const float correction = exp2_of(kSensitivityCorrection);
        const double powers = sum_of_rows<double>(reference.height_px, [&](int y) {
            double row = 0.0;
            for (int x = 0; x < reference.width_px; ++x) {
                const float background = std::max(backgrounds[band].row(y)[x], kLowestBackground);
                const auto contrast = [&](const Plane& fine, const Plane& coarse) {
                    const float c = gain * (fine.row(y)[x] - coarse.row(y)[x]) / background;
                    return std::clamp(c, -kHighestContrast, kHighestContrast);
                };
                const float sensitivity =
                    correction * tables_[channel].at(frequency + band_view.log2_factor(x, y),
                                                     log2_of(background));
                const float difference =
                    visible_difference(contrast(test, coarse_t), contrast(reference, coarse_r),
                                       sensitivity, kMaskingExponents[channel]);
                row += double{power_of(difference, kPixelNorm)};
            }
            return row;
        });
        const double mean = powers / static_cast<double>(reference.values.size());
        bands_.push_back(std::pow(mean, 1.0 / double{kPixelNorm}));
        sum += bands_.back();
    }
    return sum;
}

double FovVideoVdp::jod() const {
    return frames_ == 0 ? 10.0 : jod_of(sum_ / frames_);
}

double FovVideoVdp::newest_jod() const {
    return jod_of(newest_);
}

}  // namespace foverig::metrics
