#include "metrics/flip_hdr.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "metrics/display_code.h"
#include "metrics/flip.h"
#include "metrics/rows.h"

namespace foverig::metrics {
namespace {

constexpr float kBrightest = 65536.0F;
constexpr double kJustBright = 0.85;

/// (k0 x^2 + k1 x + k2) / (k3 x^2 + k4 x + k5).
struct Curve {
    std::array<double, 6> k;

    double operator()(double x) const {
        return ((k[0] * x + k[1]) * x + k[2]) / ((k[3] * x + k[4]) * x + k[5]);
    }

    /// The larger x at which the curve is y.
    double inverse(double y) const {
        const double a = k[0] - y * k[3];
        const double b = k[1] - y * k[4];
        const double c = k[2] - y * k[5];
        if (a == 0.0) return -c / b;
        const double root = std::sqrt(b * b - 4.0 * a * c);
        return std::max((-b + root) / (2.0 * a), (-b - root) / (2.0 * a));
    }
};

Curve hable() {
    constexpr double kA = 0.15, kB = 0.5, kC = 0.1, kD = 0.2, kE = 0.02, kF = 0.3, kWhite = 11.2;
    Curve curve{{4.0 * (kA * kF - kA * kE), 2.0 * (kC * kB * kF - kB * kE), 0.0, 4.0 * kA * kF,
                 2.0 * kB * kF, kD * kF * kF}};
    const double white = curve(0.5 * kWhite);  // the curve takes half of what Hable's own does
    for (std::size_t i = 0; i < 3; ++i) curve.k[i] /= white;
    return curve;
}

/// Reinhard's is of the luminance, the others of each channel.
Curve curve_of(ToneMapper tone_mapper) {
    switch (tone_mapper) {
        case ToneMapper::hable:
            return hable();
        case ToneMapper::reinhard:
            return {{0.0, 1.0, 0.0, 0.0, 1.0, 1.0}};
        case ToneMapper::aces:
            break;
    }
    return {{0.6 * 0.6 * 2.51, 0.6 * 0.03, 0.0, 0.6 * 0.6 * 2.43, 0.6 * 0.59, 0.14}};
}

vec3 in_range(const vec3& p) {
    return glm::clamp(p, vec3(0.0F), vec3(kBrightest));
}

float luminance(const vec3& p) {
    return 0.2126F * p.x + 0.7152F * p.y + 0.0722F * p.z;
}

Image exposed(const Image& image, double exposure, ToneMapper tone_mapper) {
    Image result{image.width_px, image.height_px, std::vector<vec3>(image.pixels.size())};
    const auto gain = static_cast<float>(std::exp2(exposure));
    std::array<float, 6> k{};
    const Curve curve = curve_of(tone_mapper);
    std::transform(curve.k.begin(), curve.k.end(), k.begin(),
                   [](double d) { return static_cast<float>(d); });
    const auto mapped = [&](float x) {
        return ((k[0] * x + k[1]) * x + k[2]) / ((k[3] * x + k[4]) * x + k[5]);
    };
    for_rows(image.height_px, [&](int y) {
        for (int x = 0; x < image.width_px; ++x) {
            const vec3 p = gain * in_range(image.at(x, y));
            if (tone_mapper == ToneMapper::reinhard)
                result.at(x, y) = p / (1.0F + luminance(p));
            else
                result.at(x, y) = {mapped(p.x), mapped(p.y), mapped(p.z)};
        }
    });
    return result;
}

}  // namespace

ExposureRange exposure_range(const Image& reference, ToneMapper tone_mapper) {
    std::vector<float> luminances(reference.pixels.size());
    std::transform(reference.pixels.begin(), reference.pixels.end(), luminances.begin(),
                   [](const vec3& p) { return luminance(in_range(p)); });
    const auto middle_of = [](std::vector<float>& values) {
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        return *middle;
    };
    if (luminances.empty()) return {0.0, 0.0, 2};
    const float brightest = *std::max_element(luminances.begin(), luminances.end());
    if (!(brightest > 0.0F)) return {0.0, 0.0, 2};
    float middle = middle_of(luminances);
    if (!(middle > 0.0F)) {
        std::erase_if(luminances, [](float y) { return !(y > 0.0F); });
        middle = middle_of(luminances);
    }
    const double bright = curve_of(tone_mapper).inverse(kJustBright);
    const double start = std::log2(bright / double{brightest});
    const double stop = std::log2(bright / double{middle});
    return {start, stop, std::max(2, static_cast<int>(std::ceil(stop - start)))};
}

Plane flip_hdr(const Image& reference, const Image& test, double pixels_per_degree,
               ToneMapper tone_mapper, const ExposureRange& exposures) {
    check_same_size(reference, test);
    Plane most(reference.width_px, reference.height_px);
    for (int i = 0; i < exposures.count; ++i) {
        const double exposure =
            exposures.start + (exposures.stop - exposures.start) * i / (exposures.count - 1);
        const Plane one = flip(exposed(reference, exposure, tone_mapper),
                               exposed(test, exposure, tone_mapper), pixels_per_degree);
        for_rows(most.height_px, [&](int y) {
            std::transform(one.row(y), one.row(y) + one.width_px, most.row(y), most.row(y),
                           [](float a, float b) { return std::max(a, b); });
        });
    }
    return most;
}

}  // namespace foverig::metrics
