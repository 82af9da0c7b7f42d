#pragma once
#include <optional>

#include "renderer/image.h"

namespace foverig::metrics {

/// Structural similarity, 1 for equal images (Wang et al. 2004): luma of the display codes, 11x11
/// Gaussian window of sigma 1.5, K1 0.01, K2 0.03, mean over the windows that lie wholly inside.
/// None where the images are smaller than a window. Symmetric.
std::optional<double> ssim(const Image& a, const Image& b);

}  // namespace foverig::metrics
