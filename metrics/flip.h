#pragma once
#include "metrics/plane.h"
#include "renderer/image.h"

namespace foverig::metrics {

/// Pixels per degree that FLIP assumes unless told: a 0.7 m wide screen of 3840 pixels, 0.7 m away.
inline constexpr double kDefaultPixelsPerDegree = 67.0206;

/// FLIP between two images on a display: an error of 0 to 1 for each pixel, as seen when one
/// flips between them at that many pixels per degree (Andersson et al. 2020, "FLIP: A Difference
/// Evaluator for Alternating Images"). Values are clamped to [0, 1]. Symmetric; 0 for equal
/// images. Both of one size and finite.
Plane flip(const Image& a, const Image& b, double pixels_per_degree);

}  // namespace foverig::metrics
