#pragma once

namespace foverig::stats {

/// Both ends belong to it.
struct Interval {
    double low = 0.0;
    double high = 0.0;
};

/// Of every interval here.
inline constexpr double kConfidence = 0.95;

}  // namespace foverig::stats
