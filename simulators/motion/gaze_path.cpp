#include "simulators/motion/gaze_path.h"

#include <algorithm>
#include <cmath>

namespace foverig::motion {

dvec2 GazeLeg::at(double t_s) const {
    const double since_s = t_s - start_s;
    return from_deg + saccade.progress(since_s) * jump_deg + since_s * glide_deg_s;
}

void GazePath::add(double start_s, const dvec2& jump_deg, const dvec2& glide_deg_s) {
    const double amplitude_deg = glm::length(jump_deg);
    legs_.push_back({start_s, end_deg(start_s), jump_deg, glide_deg_s,
                     amplitude_deg > 0.0 ? SaccadeProfile(amplitude_deg) : SaccadeProfile()});
}

double GazePath::phase_s(double t_s) const {
    return t_s - std::floor(t_s / cycle_s_) * cycle_s_;
}

const GazeLeg& GazePath::leg_at(double t_s) const {
    const auto next =
        std::upper_bound(legs_.begin(), legs_.end(), phase_s(t_s),
                         [](double t, const GazeLeg& leg) { return t < leg.start_s; });
    return next == legs_.begin() ? legs_.front() : *(next - 1);
}

}  // namespace foverig::motion
