#pragma once
// Which metrics there are for `foverig diff`, and what each says of a pair or a sequence of images.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "metrics/change.h"
#include "metrics/flicker.h"
#include "metrics/flip_hdr.h"
#include "metrics/fovvideovdp.h"
#include "metrics/plane.h"
#include "metrics/regional_change.h"
#include "renderer/image_read.h"

namespace foverig {

struct DiffSettings {
    double pixels_per_degree = 0.0;
    double fovea_deg = 0.0;
    double frames_per_s = 0.0;
    std::optional<dvec2> gaze_px;  ///< none: the middle of the image
    metrics::ToneMapper tone_mapper = metrics::ToneMapper::aces;
    metrics::ScreenLight light;
    std::vector<std::string> metrics;  ///< of all_metrics(); empty: all that there is to say
};

/// Names, in the order in which they are printed.
const std::vector<std::string>& all_metrics();

/// Collects frames: pairs of images of one size, finite.
class DiffMetrics {
  public:
    /// `sequence`: more than one frame will come, so their order in time counts.
    DiffMetrics(const DiffSettings& settings, bool sequence);

    void add(const ReadImage& reference, const ReadImage& test);

    /// {"flip": {"mean": ...}, ...}: means over the frames (of "max" and "min" the extremes).
    nlohmann::ordered_json result() const;
    /// Of the last frame; empty if FLIP was not asked for.
    const metrics::Plane& flip_map() const { return flip_map_; }

  private:
    bool wanted(const std::string& metric) const;
    nlohmann::ordered_json of_pair(const ReadImage& reference, const ReadImage& test);
    metrics::GazedView view_of(const Image& image) const;

    DiffSettings settings_;
    nlohmann::ordered_json sum_;
    int frames_ = 0;
    metrics::Plane flip_map_;
    metrics::ChangeOverTime change_;
    metrics::Flicker flicker_;
    metrics::RegionalChangeOverTime regional_;
    metrics::FovVideoVdp vdp_, foveated_vdp_;
};

}  // namespace foverig
