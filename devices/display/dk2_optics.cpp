#include "devices/display/dk2_optics.h"

#include <algorithm>
#include <cmath>

namespace foverig {
namespace {

constexpr double kPanelWidth_m = 0.12576, kPanelHeight_m = 0.07074;
constexpr double kLensSeparation_m = 0.0635;
constexpr double kPerTan_m = 0.036;
constexpr dvec2 kTanEyeAngleScale{0.25 * kPanelWidth_m / kPerTan_m,
                                  0.5 * kPanelHeight_m / kPerTan_m};
constexpr double kMaxPanelRadius = 4;

constexpr int kSegments = 10;
constexpr std::array<double, kSegments + 1> kK{1.003, 1.020, 1.042, 1.066, 1.094, 1.126,
                                               1.162, 1.203, 1.250, 1.310, 1.380};

constexpr std::array<double, 4> kChromaAt8mm{-0.0112, -0.015, 0.0187, 0.015};
constexpr std::array<double, 4> kChromaAt18mm{-0.015, -0.020, 0.025, 0.020};

double hermite(double p0, double p1, double m0, double m1, double t) {
    const double u = 1 - t;
    return (p0 * (1 + 2 * t) + m0 * t) * u * u + (p1 * (1 + 2 * u) - m1 * u) * t * t;
}

// Catmull-Rom through K over r2 in 0..1. The first segment starts at 1.0, not at K[0].
double green_scale(double r2) {
    const double at = r2 * kSegments;
    if (!(at < kSegments))
        return kK[kSegments] + (kK[kSegments] - kK[kSegments - 1]) * (at - kSegments);
    const auto i = static_cast<std::size_t>(at);  // NaN took the branch above
    const double t = at - static_cast<double>(i);
    const double m1 =
        i + 1 < kSegments ? 0.5 * (kK[i + 2] - kK[i]) : kK[kSegments] - kK[kSegments - 1];
    if (i == 0) return hermite(1.0, kK[1], kK[1] - kK[0], m1, t);
    return hermite(kK[i], kK[i + 1], 0.5 * (kK[i + 1] - kK[i - 1]), m1, t);
}

dvec2 lens_center(Eye eye) {
    const double left = 2 * (kPanelWidth_m - kLensSeparation_m) / kPanelWidth_m - 1;
    return {eye == Eye::left ? left : -left, 0};
}

}  // namespace

Dk2Optics::Dk2Optics(double eye_relief_m) {
    const double blend = std::clamp((eye_relief_m - 0.008) / 0.010, 0.0, 1.0);
    for (std::size_t i = 0; i < chroma_.size(); ++i) {
        chroma_[i] = kChromaAt8mm[i] + blend * (kChromaAt18mm[i] - kChromaAt8mm[i]);
    }
}

double Dk2Optics::scale(double r2, Channel channel) const {
    const double green = green_scale(r2);
    if (channel == Channel::red) return green * (1 + chroma_[0] + r2 * chroma_[1]);
    if (channel == Channel::blue) return green * (1 + chroma_[2] + r2 * chroma_[3]);
    return green;
}

double Dk2Optics::inverse(double tan_radius, Channel channel) const {
    const auto error = [&](double r) { return r * scale(r * r, channel) - tan_radius; };
    if (tan_radius <= 0) return 0;
    if (error(kMaxPanelRadius) <= 0) return kMaxPanelRadius;
    double low = 0, high = kMaxPanelRadius;
    double r = std::min(tan_radius, high);
    // Secant steps kept inside the bracket; bisection where they leave it. r * scale(r2) grows with
    // r.
    for (int i = 0; i < 100; ++i) {
        const double e = error(r);
        (e > 0 ? high : low) = r;
        constexpr double kStep = 1e-6;
        const double slope = (error(r + kStep) - error(r - kStep)) / (2 * kStep);
        double next = r - e / slope;
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        if (std::abs(next - r) <= 1e-15 * (1 + r)) return next;
        r = next;
    }
    return r;
}

dvec2 Dk2Optics::tangent(Eye eye, const dvec2& ndc, Channel channel) const {
    const dvec2 d = (ndc - lens_center(eye)) * kTanEyeAngleScale;
    return d * scale(glm::dot(d, d), channel);
}

dvec2 Dk2Optics::ndc(Eye eye, const dvec2& tangent, Channel channel) const {
    const double tan_radius = glm::length(tangent);
    const dvec2 d =
        tan_radius > 0 ? tangent * (inverse(tan_radius, channel) / tan_radius) : dvec2(0);
    return d / kTanEyeAngleScale + lens_center(eye);
}

std::array<dvec2, 3> Dk2Optics::pixel_tangents(Eye eye, int x_px, int y_px) const {
    const dvec2 place{2 * (x_px + 0.5) / kEyePanel.width - 1,
                      1 - 2 * (y_px + 0.5) / kEyePanel.height};
    return {tangent(eye, place, Channel::red), tangent(eye, place, Channel::green),
            tangent(eye, place, Channel::blue)};
}

TangentFrustum Dk2Optics::frustum(Eye eye) const {
    const dvec2 center = lens_center(eye);
    return {.up = tangent(eye, {center.x, 1}).y,
            .down = -tangent(eye, {center.x, -1}).y,
            .left = -tangent(eye, {-1, 0}).x,
            .right = tangent(eye, {1, 0}).x};
}

double Dk2Optics::pixels_per_tan_at_center() const {
    return 0.5 * kEyePanel.width / (kTanEyeAngleScale.x * green_scale(0));
}

SizePx Dk2Optics::texture_size(double density) const {
    const TangentFrustum f = frustum(Eye::left);
    const double px = pixels_per_tan_at_center() * density;
    return {static_cast<int>(std::floor(0.5 + px * (f.left + f.right))),
            static_cast<int>(std::floor(0.5 + px * (f.up + f.down)))};
}

}  // namespace foverig
