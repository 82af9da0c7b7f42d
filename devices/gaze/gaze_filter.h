#pragma once
// Gaze for rendering: smooth in a fixation, immediate in a saccade, held while an eye is shut or
// lost. Velocity threshold after I-VT (DEVICES.md 4.4).
#include <array>
#include <optional>

#include "devices/gaze/gaze_sample.h"

namespace foverig {

struct GazeFilterConfig {
    double saccade_deg_s = 30;  ///< faster is a saccade: no smoothing
    Nanoseconds velocity_baseline{
        12'000'000};  ///< velocity spans at least this, so that noise is not speed
    double fixation_time_constant_s = 0.030;  ///< one-pole low-pass; 0 passes everything through
    double min_confidence = 0.6;              ///< less (the lids' edge of a blink) is held
    Nanoseconds hold_limit{500'000'000};      ///< longer without an eye: not usable
};

struct FilteredEye {
    dvec3 direction{0, 0, -1};  ///< unit, in the head's frame
    Nanoseconds age{};          ///< asked time - mid-exposure of the sample it rests on
    bool held = true;           ///< the newest sample had nothing for this eye
    bool saccade = false;
    bool usable = false;  ///< something was seen within the hold limit
};

struct FilteredGaze {
    FilteredEye left{}, right{}, combined{};
};

class GazeFilter {
  public:
    explicit GazeFilter(const GazeFilterConfig& config = {}) : config_(config) {}

    /// Samples in order of time; one that is not later than the last is ignored.
    void add(const GazeSample& sample);
    /// The gaze to render for light at `photon`: the last direction, held. An eye without its own
    /// ray follows the combined one.
    FilteredGaze at(HostTime photon) const;

  private:
    struct Seen {
        HostTime time;
        dvec3 direction;
    };
    struct Track {
        std::optional<Seen> filtered;
        std::array<std::optional<Seen>, 8> recent;  ///< raw, newest first
        bool held = true, saccade = false;
    };

    void add(Track& track, HostTime time, const GazeRay& ray);
    FilteredEye at(const Track& track, HostTime photon) const;

    GazeFilterConfig config_;
    std::optional<HostTime> last_;
    Track left_, right_, combined_;
};

}  // namespace foverig
