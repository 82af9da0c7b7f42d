#include "renderer/scene/builtin/exact.h"

namespace foverig::builtin {
namespace {

// Taylor series on an eighth of a turn; in double their rest is below float's rounding.
double sine_series(double x) {
    const double x2 = x * x;
    return x * (1.0 - x2 / 6.0 * (1.0 - x2 / 20.0 * (1.0 - x2 / 42.0 * (1.0 - x2 / 72.0))));
}

double cosine_series(double x) {
    const double x2 = x * x;
    return 1.0 - x2 / 2.0 * (1.0 - x2 / 12.0 * (1.0 - x2 / 30.0 * (1.0 - x2 / 56.0)));
}

constexpr double kTwoPi = 6.283185307179586;

}  // namespace

float sine(float turns) {
    const double quarter = std::floor(4.0 * static_cast<double>(turns) + 0.5);
    const double x = kTwoPi * (static_cast<double>(turns) - quarter * 0.25);
    switch (static_cast<long>(quarter) & 3) {
        case 0:
            return static_cast<float>(sine_series(x));
        case 1:
            return static_cast<float>(cosine_series(x));
        case 2:
            return static_cast<float>(-sine_series(x));
        default:
            return static_cast<float>(-cosine_series(x));
    }
}

float cosine(float turns) {
    return sine(turns + 0.25F);
}

vec3 rotate_y(const vec3& v, float turns) {
    const float c = cosine(turns);
    const float s = sine(turns);
    return {c * v.x + s * v.z, v.y, c * v.z - s * v.x};
}

float linear_of_srgb(float srgb) {
    if (srgb <= 0.04045F) return srgb / 12.92F;
    const double base = (static_cast<double>(srgb) + 0.055) / 1.055;
    // base^2.4 = base^2 * (base^(1/5))^2; Newton from above converges for base in (0, 1].
    double root = 1.0;
    for (int i = 0; i < 24; ++i) {
        const double r4 = root * root * root * root;
        root -= (r4 * root - base) / (5.0 * r4);
    }
    return static_cast<float>(base * base * root * root);
}

}  // namespace foverig::builtin
