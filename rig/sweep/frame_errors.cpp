#include "rig/sweep/frame_errors.h"

#include <numbers>

#include "metrics/display_code.h"
#include "metrics/eccentricity.h"
#include "metrics/finite.h"
#include "metrics/flip.h"
#include "metrics/pooling.h"

namespace foverig::sweep {

std::map<std::string, double> errors_of(const Image& reference, const Image& test,
                                        const EyeInput& eye) {
    using namespace metrics;
    const Image r = with_finite_values(reference);
    const Image t = with_finite_values(test);
    const GazedView view = gazed_view(eye);
    const Plane absolute = absolute_error(r, t);
    const Plane flipped = flip(r, t, view.focal_x_px * std::numbers::pi / 180.0);
    const GazedError seen = pool_by_gaze(absolute, view, kFoveaDeg);
    return {{"absolute", pool(absolute).mean},
            {"flip", pool(flipped).mean},
            {"acuity", seen.acuity},
            {"flip_acuity", pool_by_gaze(flipped, view, kFoveaDeg).acuity},
            {"fovea", seen.fovea},
            {"periphery", seen.periphery}};
}

}  // namespace foverig::sweep
