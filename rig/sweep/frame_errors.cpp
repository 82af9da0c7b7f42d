#include "rig/sweep/frame_errors.h"

#include <numbers>

#include "metrics/display_code.h"
#include "metrics/eccentricity.h"
#include "metrics/finite.h"
#include "metrics/flip.h"
#include "metrics/pooling.h"

namespace foverig::sweep {

namespace {

constexpr double kFullScale = 255.0;  // of display codes
constexpr double kNoDifference_jod = 10.0;

}  // namespace

FrameErrors::FrameErrors(double frames_per_s, bool fvvdp) : flicker_(frames_per_s) {
    if (fvvdp) vdp_.emplace(metrics::ScreenLight{}, frames_per_s);
}

std::map<std::string, double> FrameErrors::add(const Image& reference, const Image& test,
                                               const EyeInput& eye) {
    using namespace metrics;
    const Image r = with_finite_values(reference);
    const Image t = with_finite_values(test);
    const GazedView view = gazed_view(eye);
    const Plane absolute = absolute_error(r, t);
    const Plane flipped = flip(r, t, view.focal_x_px * std::numbers::pi / 180.0);
    const GazedError seen = pool_by_gaze(absolute, view, kFoveaDeg);
    change_.add(r, t);
    flicker_.add(r, t);
    std::map<std::string, double> errors{
        {"absolute", pool(absolute).mean},
        {"flip", pool(flipped).mean},
        {"acuity", seen.acuity},
        {"flip_acuity", pool_by_gaze(flipped, view, kFoveaDeg).acuity},
        {"fovea", seen.fovea},
        {"periphery", seen.periphery},
        {"change", change_.newest().mae / kFullScale},
        {"flicker", flicker_.newest_rms_codes() / kFullScale}};
    if (vdp_) {
        vdp_->add(r, t, view, true);
        errors["fvvdp"] = kNoDifference_jod - vdp_->newest_jod();
    }
    return errors;
}

void FrameErrors::see(const Image& reference, const Image& test) {
    const Image r = metrics::with_finite_values(reference);
    const Image t = metrics::with_finite_values(test);
    change_.see(r, t);
    flicker_.see(r, t);
    if (vdp_) vdp_->see(r, t);
}

}  // namespace foverig::sweep
