#pragma once
// Colour in FLIP: from linear RGB to the opponent space that is filtered, and on to L*a*b*.
#include "metrics/power.h"
#include "renderer/vec.h"

namespace foverig::metrics {

/// XYZ of white (D65): the sums of the rows below.
inline constexpr float kWhiteX = 0.950428545F, kWhiteZ = 1.088900371F;

/// YCxCz without its factors and offset, which filters that sum to 1 pass through:
/// (Y, X/Xn - Y, Y - Z/Zn).
struct Opponent {
    float y, cx, cz;
};

inline Opponent opponent_of(const vec3& rgb) {
    const float x = 0.412386563F * rgb.x + 0.357591427F * rgb.y + 0.180450555F * rgb.z;
    const float y = 0.212636816F * rgb.x + 0.715182853F * rgb.y + 0.072180331F * rgb.z;
    const float z = 0.0193306048F * rgb.x + 0.119197145F * rgb.y + 0.950372621F * rgb.z;
    return {y, x / kWhiteX - y, y - z / kWhiteZ};
}

inline float clamped(float x) {
    return std::min(std::max(x, 0.0F), 1.0F);
}

/// Back to linear RGB, clamped to what a display shows.
inline vec3 rgb_of(const Opponent& o) {
    const float x = (o.y + o.cx) * kWhiteX;
    const float z = (o.y - o.cz) * kWhiteZ;
    return {clamped(3.241003275F * x - 1.537398934F * o.y - 0.498615861F * z),
            clamped(-0.969224334F * x + 1.875930071F * o.y + 0.041554224F * z),
            clamped(0.055639423F * x - 0.204011202F * o.y + 1.057148933F * z)};
}

inline float lab_curve(float t) {
    constexpr float kDelta = 6.0F / 29.0F;
    const float root = power_of(t, 1.0F / 3.0F);
    return t > kDelta * kDelta * kDelta ? root : t / (3.0F * kDelta * kDelta) + 4.0F / 29.0F;
}

/// L*a*b* of linear RGB in [0, 1], a and b weakened where it is dark (Hunt effect).
inline vec3 hunt_lab_of(const vec3& rgb) {
    const Opponent o = opponent_of(rgb);
    const float fx = lab_curve(o.y + o.cx);
    const float fy = lab_curve(o.y);
    const float fz = lab_curve(o.y - o.cz);
    const float lightness = 116.0F * fy - 16.0F;
    const float hunt = 0.01F * lightness;
    return {lightness, 500.0F * (fx - fy) * hunt, 200.0F * (fy - fz) * hunt};
}

/// Distance in that space, 0 to 1: HyAB to the power 0.7, small ones spread out.
inline float colour_error(const vec3& a, const vec3& b) {
    constexpr float kMost = 41.276098F;  // green against blue
    constexpr float kKnee = 0.4F * kMost, kKneeError = 0.95F;
    const float da = a.y - b.y;
    const float db = a.z - b.z;
    const float e = power_of(std::abs(a.x - b.x) + std::sqrt(da * da + db * db), 0.7F);
    return e < kKnee ? e * (kKneeError / kKnee)
                     : kKneeError + (e - kKnee) * ((1.0F - kKneeError) / (kMost - kKnee));
}

}  // namespace foverig::metrics
