#pragma once
// Arithmetic that gives the same bits on every machine: + - * / sqrt and floor in a stated order.
// This library is compiled without contraction, and calls neither libm's sine and power nor GLM's
// dot, cross and normalize, which another translation unit may have compiled with contraction.
#include <cmath>

#include "renderer/vec.h"

namespace foverig::builtin {

inline float dot(const vec3& a, const vec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline vec3 cross(const vec3& a, const vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline float length(const vec3& a) {
    return std::sqrt(dot(a, a));
}
inline float length(const vec2& a) {
    return std::sqrt(a.x * a.x + a.y * a.y);
}

/// Zero stays zero.
inline vec3 normalize(const vec3& a) {
    const float norm = length(a);
    return norm > 0.0F ? a / norm : vec3{0.0F};
}

inline float clamp(float x, float low, float high) {
    return x < low ? low : x > high ? high : x;
}
inline float mix(float a, float b, float t) {
    return a + (b - a) * t;
}
inline vec3 mix(const vec3& a, const vec3& b, float t) {
    return a + (b - a) * t;
}

/// 0 below `low`, 1 above `high`, cubic between; low < high.
inline float smoothstep(float low, float high, float x) {
    const float t = clamp((x - low) / (high - low), 0.0F, 1.0F);
    return t * t * (3.0F - 2.0F * t);
}

inline float fract(float x) {
    return x - std::floor(x);
}

/// Sine and cosine of an angle in turns (1 = 360 deg); exact at quarter turns, error below 1e-6.
float sine(float turns);
float cosine(float turns);

/// Rotates about +y by an angle in turns, counter-clockwise seen from above.
vec3 rotate_y(const vec3& v, float turns);

/// IEC 61966-2-1 decoding, without libm's pow.
float linear_of_srgb(float srgb);

}  // namespace foverig::builtin
