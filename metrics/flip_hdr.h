#pragma once
#include "metrics/plane.h"
#include "renderer/image.h"

namespace foverig::metrics {

enum class ToneMapper { aces, hable, reinhard };

/// Exposures as powers of 2, evenly spaced, both ends included.
struct ExposureRange {
    double start = 0.0;
    double stop = 0.0;
    int count = 0;  ///< >= 2
};

/// From where the brightest pixel of the reference to where its middle one is just bright
/// (Andersson et al. 2021, "Visualizing and Communicating Errors in Rendered Images", 4.2). Where
/// more than half of the pixels are black, the middle of the others; all black: 0 to 0.
ExposureRange exposure_range(const Image& reference, ToneMapper tone_mapper);

/// HDR-FLIP: the largest FLIP of each pixel over the exposures, each tone mapped. Values are
/// clamped to [0, 65536]. Symmetric but for the exposures, which come from the reference.
Plane flip_hdr(const Image& reference, const Image& test, double pixels_per_degree,
               ToneMapper tone_mapper, const ExposureRange& exposures);

}  // namespace foverig::metrics
