#pragma once
#include "metrics/plane.h"

namespace foverig::metrics {

/// An error map as a few numbers. Weighted quantile q: errors in order, the first at which their
/// running sum exceeds q times the whole (Andersson et al. 2020, 5.1); large errors count for more.
struct Pooled {
    double mean = 0.0;
    double weighted_q1 = 0.0;
    double weighted_median = 0.0;
    double weighted_q3 = 0.0;
    double min = 0.0;
    double max = 0.0;
};

/// Of errors >= 0, all finite; all 0 of an empty map.
Pooled pool(const Plane& errors);

}  // namespace foverig::metrics
