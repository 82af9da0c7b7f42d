#pragma once
// From the eyes' true motion to what an SMI-style tracker measures (DEVICES.md 5.4, 5.5), and what
// a calibration makes of that. With no fault named, the sample is the truth.
#include <array>
#include <cstdint>
#include <optional>

#include "devices/gaze/frames.h"
#include "simulators/faults/faults.h"
#include "simulators/gaze/calibration_map.h"
#include "simulators/gaze/tracker_geometry.h"
#include "simulators/gaze/user_eye.h"
#include "simulators/motion/blinks.h"
#include "simulators/motion/random.h"

namespace foverig {

class TrackerModel {
  public:
    static constexpr double kNoiseLag1 = 0.3;      ///< autocorrelation from sample to sample
    static constexpr double kNoiseShared = 0.125;  ///< of the two eyes: combined STD x 0.75
    static constexpr double kInvalidBelow = 0.35;  ///< openness
    static constexpr double kLowPass_hz = 8.0;

    /// `eyes` outlives the model.
    TrackerModel(const motion::EyeMotion& eyes, const GazeFaults& faults, std::uint64_t seed);

    /// What one exposure gives; call in order of time, as the noise remembers. Header, times and
    /// counters are the caller's. `unseen`: the tracker sees no eye, and why.
    gaze::SampleFrame measure(double t_s, double rate_hz, bool low_pass,
                              std::optional<gaze::EyeCause> unseen);

    using Gaze = std::array<dvec2, 2>;  ///< degrees, left and right
    /// Of the last exposure, before any calibration; absent where the eyes were not seen well.
    const std::optional<Gaze>& raw_deg() const { return raw_deg_; }

    using Maps = std::array<CalibrationMap, 2>;  ///< left, right
    /// From the next exposure on; none: what is measured is sent.
    void calibrate(const std::optional<Maps>& maps) { maps_ = maps; }
    const std::optional<Maps>& maps() const { return maps_; }

  private:
    motion::EyeState state_at(double t_s) const;
    bool near_blink(double t_s, double period_s) const;
    Gaze measured_deg(const Gaze& true_deg, double ecc_deg, double t_s, std::uint64_t index);
    void step_noise(double ecc_deg, std::uint64_t index);
    dvec2 systematic_error_deg(std::size_t eye, const dvec2& gaze_deg, double t_s) const;
    void smooth(Gaze& gaze, double rate_hz);

    const motion::EyeMotion& eyes_;
    std::optional<motion::BlinkingEye> blinking_;
    std::optional<std::array<UserEye, 2>> user_;
    std::optional<Maps> maps_;
    std::optional<Gaze> raw_deg_;
    GazeFaults faults_;
    motion::Draws noise_;
    Gaze noise_deg_{};
    Gaze offset_deg_{};
    dvec2 slip_direction_{0.0};
    std::uint64_t samples_ = 0;
    std::optional<Gaze> smoothed_;
};

/// A sample in which that eye's lid is down and the other's is not: the combined ray is the other
/// eye's (DEVICES.md 4.5.3, rule f), and how far both look is not known.
void shut_eye(gaze::SampleFrame& frame, Side side);

}  // namespace foverig
