#pragma once
#include <vector>

#include "metrics/power.h"

namespace foverig::metrics {

/// How sensitive the eye is to contrast: one over the smallest that is seen (Mantiuk et al. 2021,
/// "FovVideoVDP", 4.3), of luminance gratings at a spatial frequency in cycles per degree on a
/// background in cd/m2, that stand still (0 Hz) or change at `temporal_hz`, so far off the gaze.
double contrast_sensitivity(double cycles_per_deg, double temporal_hz, double background_cd_m2,
                            double eccentricity_deg);

/// Off the gaze a frequency is seen like a higher one at it: by how much, base 2 logarithm, 0 at
/// the gaze (cortical magnification).
inline float log2_cortical_demagnification(float eccentricity_deg) {
    constexpr float kHalf_deg = 3.67F, kLog2OfHalf = 1.87578010F, kExponent = 0.604562F;
    return kExponent * (log2_of(eccentricity_deg + kHalf_deg) - kLog2OfHalf);
}

/// The same for one temporal frequency from a table, so that pixels can ask. Frequencies of 1/64 to
/// 128 cycles per degree and backgrounds of 0.01 to 10^4 cd/m2; beyond them as at the nearest.
class SensitivityTable {
  public:
    explicit SensitivityTable(double temporal_hz);

    /// At the gaze. Logarithms to base 2. Within 0.5 % of contrast_sensitivity where that is above
    /// 0.01.
    float at(float log2_cycles_per_deg, float log2_background_cd_m2) const;

  private:
    std::vector<float> log2_sensitivity_;  ///< by frequency, then background
};

}  // namespace foverig::metrics
