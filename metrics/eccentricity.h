#pragma once
#include "metrics/plane.h"
#include "renderer/camera.h"

namespace foverig::metrics {

/// Where the pixels of a flat (pinhole) image lie in the field of view, and where the eye looks.
struct GazedView {
    double focal_x_px = 0.0, focal_y_px = 0.0;    ///< pixels per unit tangent
    double centre_x_px = 0.0, centre_y_px = 0.0;  ///< straight ahead, from the top left corner
    double gaze_x_px = 0.0, gaze_y_px = 0.0;
};

/// An eye of a frame. Its gaze must lie before it.
GazedView gazed_view(const EyeInput& eye);

/// A screen seen from straight before its middle, where it has so many pixels per degree.
GazedView gazed_screen(int width_px, int height_px, double pixels_per_degree, double gaze_x_px,
                       double gaze_y_px);

/// An error map's mean where the eye looks and where not.
struct GazedError {
    std::size_t fovea_pixels = 0;
    double fovea = 0.0;      ///< mean of the pixels within the fovea; 0 of none
    double periphery = 0.0;  ///< mean of the others
    double acuity = 0.0;     ///< our own: mean over what the eye can resolve, see below
};

/// The fovea ends `fovea_deg` from the gaze. The acuity-weighted mean is this project's own
/// definition: a pixel's weight is its solid angle by the square of the smallest angle resolved at
/// its eccentricity e, 1/48 + 0.022 e degrees (Guenter et al. 2012, "Foveated 3D Graphics"): each
/// resolvable cell of the visual field counts once.
GazedError pool_by_gaze(const Plane& errors, const GazedView& view, double fovea_deg);

}  // namespace foverig::metrics
