#pragma once
// The eye's way as a list of legs: a saccade (perhaps of length 0), then a glide at constant speed.
// Fixations, pursuit and corrections are all made of these.
#include <vector>

#include "devices/math.h"
#include "simulators/motion/saccade.h"

namespace foverig::motion {

struct GazeLeg {
    double start_s = 0.0;
    dvec2 from_deg{0.0};  ///< where the eye is when the leg starts
    dvec2 jump_deg{0.0};  ///< the saccade's way; it runs on top of the glide
    dvec2 glide_deg_s{0.0};
    SaccadeProfile saccade;

    bool jumping(double t_s) const { return t_s - start_s < saccade.duration_s(); }
    dvec2 at(double t_s) const;
};

/// Legs in order of time; the way repeats after `cycle_s`, and the last leg should lead back to
/// where the first one starts.
class GazePath {
  public:
    explicit GazePath(double cycle_s) : cycle_s_(cycle_s) {}

    /// Starts a leg where the last one has led by then; `start_s` does not go back.
    void add(double start_s, const dvec2& jump_deg, const dvec2& glide_deg_s);
    dvec2 gaze_deg(double t_s) const { return leg_at(t_s).at(phase_s(t_s)); }
    bool jumping(double t_s) const { return leg_at(t_s).jumping(phase_s(t_s)); }
    /// Where the way has led so far.
    dvec2 end_deg(double t_s) const { return legs_.empty() ? dvec2(0.0) : legs_.back().at(t_s); }

    double cycle_s() const { return cycle_s_; }
    const std::vector<GazeLeg>& legs() const { return legs_; }

  private:
    double phase_s(double t_s) const;
    const GazeLeg& leg_at(double t_s) const;

    double cycle_s_;
    std::vector<GazeLeg> legs_;
};

}  // namespace foverig::motion
