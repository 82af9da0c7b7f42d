#pragma once
// A wide lens as OpenCV's fisheye module calibrates it (Kannala and Brandt 2006): the distance from
// the centre is a polynomial of the angle from the axis, so that more than half of all directions
// can be seen. Camera frame and pixels are those of lens.h.
#include <array>
#include <optional>

#include "devices/math.h"

namespace foverig::camera {

class FisheyeLens {
  public:
    struct Numbers {
        double fx_px = 1.0, fy_px = 1.0;  ///< pixels a radian at the axis
        double cx_px = 0.0, cy_px = 0.0;
        std::array<double, 4> k{};  ///< k1 to k4
        bool operator==(const Numbers&) const = default;
    };
    explicit FisheyeLens(const Numbers& numbers);

    const Numbers& numbers() const { return numbers_; }
    /// The angle from the axis at which the polynomial first folds back; pi where it does not.
    double fold_rad() const { return fold_rad_; }

    /// Nothing for points beyond the fold or straight behind.
    std::optional<dvec2> project(const dvec3& camera_m) const;
    /// The inverse: the direction that falls on a pixel, of length 1. Nothing where none does.
    std::optional<dvec3> ray_at(const dvec2& pixel) const;

    bool operator==(const FisheyeLens&) const = default;

  private:
    double radius(double angle_rad) const;
    double growth(double angle_rad) const;

    Numbers numbers_;
    double fold_rad_;
};

}  // namespace foverig::camera
