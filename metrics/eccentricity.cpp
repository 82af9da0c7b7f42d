#include "metrics/eccentricity.h"

#include <cmath>
#include <numbers>

#include "metrics/rows.h"

namespace foverig::metrics {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kSmallestAngle_deg = 1.0 / 48.0, kPerEccentricity = 0.022;

struct Sums {
    std::size_t fovea_pixels = 0;
    std::size_t pixels = 0;
    double fovea = 0.0;
    double all = 0.0;
    double weighted = 0.0;
    double weights = 0.0;

    Sums& operator+=(const Sums& o) {
        fovea_pixels += o.fovea_pixels;
        pixels += o.pixels;
        fovea += o.fovea;
        all += o.all;
        weighted += o.weighted;
        weights += o.weights;
        return *this;
    }
};

dvec3 direction_of(const GazedView& view, double x_px, double y_px) {
    return {(x_px - view.centre_x_px) / view.focal_x_px,
            (y_px - view.centre_y_px) / view.focal_y_px, 1.0};
}

}  // namespace

GazedView gazed_view(const EyeInput& eye) {
    const EyeView& v = eye.view;
    const double focal_x_px = v.width_px / (double{v.tan_left} + double{v.tan_right});
    const double focal_y_px = v.height_px / (double{v.tan_down} + double{v.tan_up});
    const dvec3 gaze(eye.gaze);
    const double centre_x_px = focal_x_px * double{v.tan_left};
    const double centre_y_px = focal_y_px * double{v.tan_up};
    return {focal_x_px,
            focal_y_px,
            centre_x_px,
            centre_y_px,
            centre_x_px - focal_x_px * gaze.x / gaze.z,
            centre_y_px + focal_y_px * gaze.y / gaze.z};
}

GazedView gazed_screen(int width_px, int height_px, double pixels_per_degree, double gaze_x_px,
                       double gaze_y_px) {
    const double focal_px = pixels_per_degree * kDegrees;
    return {focal_px, focal_px, 0.5 * width_px, 0.5 * height_px, gaze_x_px, gaze_y_px};
}

GazedError pool_by_gaze(const Plane& errors, const GazedView& view, double fovea_deg) {
    const dvec3 gaze = glm::normalize(direction_of(view, view.gaze_x_px, view.gaze_y_px));
    const Sums sums = sum_of_rows<Sums>(errors.height_px, [&](int y) {
        Sums s;
        const float* row = errors.row(y);
        for (int x = 0; x < errors.width_px; ++x) {
            const dvec3 d = direction_of(view, x + 0.5, y + 0.5);
            const double length = glm::length(d);
            const double angle_deg =
                kDegrees * std::atan2(glm::length(glm::cross(d, gaze)), glm::dot(d, gaze));
            const double resolved_deg = kSmallestAngle_deg + kPerEccentricity * angle_deg;
            // A pixel's solid angle goes with the cube of the cosine off the axis.
            const double weight = 1.0 / (length * length * length * resolved_deg * resolved_deg);
            const double e = double{row[x]};
            ++s.pixels;
            s.all += e;
            s.weighted += weight * e;
            s.weights += weight;
            if (angle_deg <= fovea_deg) {
                ++s.fovea_pixels;
                s.fovea += e;
            }
        }
        return s;
    });
    const auto mean = [](double sum, double n) { return n > 0.0 ? sum / n : 0.0; };
    return {.fovea_pixels = sums.fovea_pixels,
            .fovea = mean(sums.fovea, static_cast<double>(sums.fovea_pixels)),
            .periphery =
                mean(sums.all - sums.fovea, static_cast<double>(sums.pixels - sums.fovea_pixels)),
            .acuity = mean(sums.weighted, sums.weights)};
}

}  // namespace foverig::metrics
