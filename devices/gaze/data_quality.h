#pragma once
// How good gaze on a target is, in degrees of visual angle, as eye tracking defines it (Holmqvist,
// Nystrom, Mulvey 2012, ETRA: "Eye tracker data quality: what it is and how to measure it").
#include <limits>
#include <vector>

#include "devices/math.h"

namespace foverig::gaze {

/// NaN where there are too few samples to say.
struct DataQuality {
    static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

    std::size_t samples = 0;
    double accuracy_deg = kUnknown;  ///< mean of the angles between gaze and target
    double rms_s2s_deg = kUnknown;   ///< root mean square of the angles between successive samples
    double sd_deg = kUnknown;        ///< root mean square of the angles from the mean direction
};

/// The samples on one target, in order of time.
class DataQualityMeter {
  public:
    void add(const dvec3& direction);
    /// What comes next does not follow what came last: a blink, a lost sample.
    void gap() { follows_ = false; }

    DataQuality against(const dvec3& target) const;

  private:
    std::vector<dvec3> directions_;
    double squared_steps_deg2_ = 0.0;
    std::size_t steps_ = 0;
    bool follows_ = false;
};

/// Mean over targets of what is known; `samples` is their sum.
DataQuality mean_of(const std::vector<DataQuality>& targets);

}  // namespace foverig::gaze
