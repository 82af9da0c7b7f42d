#pragma once
#include "renderer/image.h"

namespace foverig::metrics {

/// How two sequences of display codes (0 to 255) change from frame to frame, means over pixels,
/// channels and pairs of frames.
struct Change {
    int pairs = 0;
    double reference =
        0.0;            ///< E' of Zhang et al. (Foveated Instant Radiosity, eq. 4): mean |R' - R|
    double test = 0.0;  ///< E' of the other: mean |T' - T|
    double mae = 0.0;   ///< mean |(T' - T) - (R' - R)|: change that the reference has not
    double mse = 0.0;   ///< mean of its square
};

/// Takes frames in their order, keeps one.
class ChangeOverTime {
  public:
    /// Both throw std::invalid_argument where a size differs from the first frame's.
    void add(const Image& reference, const Image& test);
    /// A frame that is not judged, but that the next one changes from.
    void see(const Image& reference, const Image& test);
    Change change() const;
    /// To the last frame that was judged from the one before; nothing where none was.
    const Change& newest() const { return newest_; }

  private:
    void take(Image reference_codes, Image test_codes);

    Image reference_, test_;  // of the frame before, display codes
    bool begun_ = false;
    Change sum_, newest_;
};

}  // namespace foverig::metrics
