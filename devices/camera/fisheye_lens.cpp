#include "devices/camera/fisheye_lens.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foverig::camera {
namespace {

constexpr int kFoldSteps = 1000;  // 0.18 degrees apart; a narrower fold is not seen
constexpr int kHalvings = 50;
constexpr int kInverseSteps = 60;
constexpr double kInverse_rad = 1e-13;

}  // namespace

FisheyeLens::FisheyeLens(const Numbers& numbers) : numbers_(numbers), fold_rad_(std::numbers::pi) {
    constexpr double kStep_rad = std::numbers::pi / kFoldSteps;
    for (int i = 1; i <= kFoldSteps; ++i) {
        if (growth(i * kStep_rad) > 0) continue;
        double grows = (i - 1) * kStep_rad, folds = i * kStep_rad;
        for (int j = 0; j < kHalvings; ++j) {
            const double middle = 0.5 * (grows + folds);
            (growth(middle) > 0 ? grows : folds) = middle;
        }
        fold_rad_ = grows;
        return;
    }
}

double FisheyeLens::radius(double angle_rad) const {
    const double s = angle_rad * angle_rad;
    const auto& k = numbers_.k;
    return angle_rad * (1 + s * (k[0] + s * (k[1] + s * (k[2] + s * k[3]))));
}

double FisheyeLens::growth(double angle_rad) const {
    const double s = angle_rad * angle_rad;
    const auto& k = numbers_.k;
    return 1 + s * (3 * k[0] + s * (5 * k[1] + s * (7 * k[2] + s * 9 * k[3])));
}

std::optional<dvec2> FisheyeLens::project(const dvec3& p) const {
    const double away = std::hypot(p.x, p.y), angle_rad = std::atan2(away, p.z);
    if (away == 0.0) {
        if (p.z > 0.0) return dvec2(numbers_.cx_px, numbers_.cy_px);
        return std::nullopt;
    }
    if (!(angle_rad <= fold_rad_)) return std::nullopt;
    const double scale = radius(angle_rad) / away;
    return dvec2(numbers_.fx_px * p.x * scale + numbers_.cx_px,
                 numbers_.fy_px * p.y * scale + numbers_.cy_px);
}

// Newton's method between bounds, as the radius only grows up to the fold.
std::optional<dvec3> FisheyeLens::ray_at(const dvec2& pixel) const {
    const dvec2 bent((pixel.x - numbers_.cx_px) / numbers_.fx_px,
                     (pixel.y - numbers_.cy_px) / numbers_.fy_px);
    const double r = std::hypot(bent.x, bent.y);
    if (r == 0.0) return dvec3(0, 0, 1);
    if (!(r <= radius(fold_rad_))) return std::nullopt;
    double low = 0.0, high = fold_rad_, angle_rad = std::min(r, fold_rad_);
    for (int i = 0; i < kInverseSteps; ++i) {
        const double off = radius(angle_rad) - r;
        if (std::abs(off) < kInverse_rad) break;
        (off < 0.0 ? low : high) = angle_rad;
        angle_rad -= off / growth(angle_rad);
        if (!(angle_rad > low && angle_rad < high)) angle_rad = 0.5 * (low + high);
    }
    return dvec3(std::sin(angle_rad) / r * bent, std::cos(angle_rad));
}

}  // namespace foverig::camera
