#pragma once
// What the tracker's firmware makes of a calibration: from what it measures of an eye to where that
// eye looks.
#include <array>
#include <optional>
#include <span>

#include "devices/bytes.h"
#include "devices/math.h"

namespace foverig {

/// Corrections in degrees as polynomials of the measured angles, about the middle of the points and
/// in units of their reach, so that the fit is well conditioned.
class CalibrationMap {
  public:
    static constexpr std::size_t kTerms = 10;  ///< 1 x y, x2 xy y2, x3 x2y xy2 y3
    static constexpr std::size_t kBytes = 8 * (3 + 2 * kTerms);

    /// Corrects nothing.
    CalibrationMap() = default;

    /// By `points`: 1 an offset; 3 an offset, a gain and a turn, as the default three points lie on
    /// one line; 5 an affine map; 9 a quadratic, 13 a cubic polynomial. Angles of points looked at,
    /// in degrees. None where the points do not determine it.
    static std::optional<CalibrationMap> fit(int points, std::span<const dvec2> measured_deg,
                                             std::span<const dvec2> wanted_deg);

    dvec2 corrected_deg(const dvec2& measured_deg) const;

    std::array<std::byte, kBytes> encode() const;
    /// None where a number is not finite.
    static std::optional<CalibrationMap> decode(std::span<const std::byte, kBytes> bytes);

    bool operator==(const CalibrationMap&) const = default;

  private:
    dvec2 middle_deg_{0.0};
    double reach_deg_ = 1.0;
    std::array<dvec2, kTerms> coefficients_{};
};

}  // namespace foverig
