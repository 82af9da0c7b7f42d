#pragma once
#include <deque>

#include "metrics/plane.h"
#include "metrics/temporal_filters.h"
#include "renderer/image.h"

namespace foverig::metrics {

/// Flicker that the reference has not; this project's own definition: the transient channel
/// (temporal_filters.h) of the luma's error, its root mean square over pixels and frames, in
/// display codes. An error that stands still gives next to nothing. Before the first frame all was
/// as in it.
class Flicker {
  public:
    explicit Flicker(double frames_per_s);

    /// Both throw std::invalid_argument where a size differs from the first frame's.
    void add(const Image& reference, const Image& test);
    /// A frame that is not judged, but through which later ones are seen.
    void see(const Image& reference, const Image& test);
    /// 0 of less than two judged frames.
    double rms_codes() const;
    /// Of the last judged frame alone; 0 of none.
    double newest_rms_codes() const;
    /// Squares of the last frame's transient channel; what rms_codes takes the mean of.
    const Plane& squares() const { return squares_; }

  private:
    TemporalFilters filters_;
    std::deque<Plane> errors_;  ///< newest first, as many as the filter reaches back
    Plane squares_;
    double mean_squares_ = 0.0, newest_mean_square_ = 0.0;
    int frames_ = 0;
};

}  // namespace foverig::metrics
