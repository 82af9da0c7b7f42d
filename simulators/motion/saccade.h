#pragma once
// One saccade after the main sequence (DEVICES.md 5.1): V = 520 (1 - e^(-A/8.5)) deg/s,
// D = 2.4 A + 22 ms, peak of velocity at D (0.45 - 0.0015 A).
namespace foverig::motion {

double saccade_peak_deg_s(double amplitude_deg);
double saccade_duration_s(double amplitude_deg);

/// Progress of a saccade from 0 to 1. The gamma function that 5.1 names cannot keep V, D and A at
/// once (with V D / A near 1.6 it still moves at 0.4 V when D is over), so each side of the peak is
/// a lobe 1 - |x|^m instead: skewed the same way, at rest at both ends, and V, D and A are exact.
class SaccadeProfile {
  public:
    SaccadeProfile() = default;
    explicit SaccadeProfile(double amplitude_deg);

    double duration_s() const { return duration_s_; }
    double progress(double since_start_s) const;    ///< 0 before, 1 after
    double rate_per_s(double since_start_s) const;  ///< derivative of `progress`

  private:
    double duration_s_ = 0.0;
    double peak_share_ = 0.45;
    double exponent_ = 1.6;
};

}  // namespace foverig::motion
