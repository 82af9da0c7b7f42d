#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "rig/stats/percentile.h"
#include "rig/sweep/merged.h"

namespace foverig::sweep {

struct Estimated {
    double value = 0.0;
    std::optional<stats::Interval> ci95;
};

struct PointErrors {
    Estimated mean;                              ///< over the frames; interval by moving blocks
    std::vector<stats::Percentile> percentiles;  ///< p50, p90 of the frames
    double worst = 0.0;                          ///< frame
};

struct PointTimes {
    Estimated ms;                 ///< mean of the runs' medians; Student's t interval
    std::vector<double> runs_ms;  ///< those medians; none at fixed cost
    std::vector<stats::Percentile> percentiles;  ///< p50, p90, p99 of all runs' frames
    double missed_ratio = 0.0;                   ///< VSyncs that repeat an older frame / all VSyncs
    std::map<std::string, double> pass_ms;       ///< means of all runs
};

/// Beyond the warm-up.
std::map<std::string, PointErrors> errors_of(const Accuracy& accuracy, std::size_t warm_up_frames);

/// A frame that takes longer than `budget_ms` misses as many VSyncs as begin while it is made.
PointTimes times_of(const std::vector<Times>& runs, std::size_t warm_up_frames, double budget_ms);

/// Of frames that take a fixed time.
PointTimes modelled_times(double ms, double budget_ms);

}  // namespace foverig::sweep
