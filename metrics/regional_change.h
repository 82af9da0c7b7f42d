#pragma once
#include <optional>

#include "metrics/eccentricity.h"
#include "metrics/flicker.h"
#include "renderer/image.h"

namespace foverig::metrics {

/// What change.h and flicker.h say of a sequence, where the eye looks and where not: means over
/// pixels and frames, in display codes. A region that held no pixel in any frame is absent.
struct RegionalChange {
    struct Region {
        double reference = 0.0;    ///< E' of the reference
        double test = 0.0;         ///< E' of the other
        double mae = 0.0;          ///< of the difference of the two changes
        double flicker_rms = 0.0;  ///< of the luma error's transient channel
    };
    std::optional<Region> fovea, periphery;
};

/// Takes frames in their order; each has a gaze of its own.
class RegionalChangeOverTime {
  public:
    RegionalChangeOverTime(double frames_per_s, double fovea_deg)
        : flicker_(frames_per_s), fovea_deg_(fovea_deg) {}

    /// Throws std::invalid_argument where a size differs from the first frame's.
    void add(const Image& reference, const Image& test, const GazedView& view);
    /// Nothing of less than two frames.
    RegionalChange change() const;

  private:
    struct Sums {
        std::size_t frames = 0;      ///< in which the region holds a pixel
        RegionalChange::Region sum;  ///< of flicker the mean squares
    };

    Flicker flicker_;
    double fovea_deg_;
    Image reference_, test_;
    int frames_ = 0;
    Sums fovea_, periphery_;
};

}  // namespace foverig::metrics
