#pragma once
#include <deque>
#include <optional>
#include <vector>

#include "metrics/contrast_sensitivity.h"
#include "metrics/eccentricity.h"
#include "metrics/temporal_filters.h"
#include "renderer/image.h"

namespace foverig::metrics {

/// Light that a screen gives off: linear 1 is the peak, 0 the black.
struct ScreenLight {
    double peak_cd_m2 = 100.0;
    double black_cd_m2 = 0.1;
};

/// FovVideoVDP: what people would say to the difference of two videos or images, given how fine and
/// bright the screen is and where they look (Mantiuk et al. 2021, "FovVideoVDP: A visible
/// difference predictor for wide field-of-view video"). Written from the paper's formulas.
/// In JOD: 10 is no difference, one less is seen by 75 % of people against 25 %.
class FovVideoVdp {
  public:
    /// No rate: each frame is a still, seen by the sustained channel alone. At least 8 Hz, else
    /// throws std::invalid_argument.
    FovVideoVdp(const ScreenLight& light, std::optional<double> frames_per_s);

    /// Frames of one size, in their order, before the first all was as in it. `view` tells how
    /// large pixels are; where the gaze is only if the vision is `foveated`, else it is sharp
    /// everywhere. Both throw std::invalid_argument where a size differs from the first frame's.
    void add(const Image& reference, const Image& test, const GazedView& view, bool foveated);
    /// A frame that is not judged, but through which later ones are seen.
    void see(const Image& reference, const Image& test);

    /// 10 of no frames.
    double jod() const;
    /// Of the last frame alone, as those before it let it be seen.
    double newest_jod() const;
    /// Per band of the last frame's sustained channel, the finest first: what jod sums.
    const std::vector<double>& band_differences() const { return bands_; }

  private:
    double channel_difference(std::size_t channel, const std::vector<Plane>& backgrounds,
                              const GazedView& view, bool foveated);
    Plane filtered(const std::deque<Plane>& frames, const std::vector<double>& taps) const;

    ScreenLight light_;
    std::vector<std::vector<double>> taps_;  ///< of each channel: sustained, transient
    std::vector<SensitivityTable> tables_;
    std::deque<Plane> references_, tests_;  ///< luminances, the newest first
    std::vector<double> bands_;
    double sum_ = 0.0, newest_ = 0.0;
    int frames_ = 0;
};

}  // namespace foverig::metrics
