#pragma once
#include "metrics/plane.h"
#include "renderer/image.h"

namespace foverig::metrics {

/// Errors of 0 to 1 in the colours that FLIP's maps have (magma: black is 0, pale yellow is 1), so
/// that write_png gives them within two codes.
Image heatmap(const Plane& errors);

}  // namespace foverig::metrics
