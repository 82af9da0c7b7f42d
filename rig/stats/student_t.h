#pragma once
#include <optional>
#include <span>

#include "rig/stats/interval.h"

namespace foverig::stats {

/// P(|T| <= t) of Student's distribution with `freedom` >= 1 degrees (Abramowitz and Stegun 1964,
/// 26.7.3 and 26.7.4), t >= 0.
double student_t_within(double t, int freedom);

/// The t that |T| stays within with kConfidence.
double student_t_bound(int freedom);

/// For the mean of independent, about normal numbers; no value of fewer than two.
std::optional<Interval> mean_interval(std::span<const double> numbers);

}  // namespace foverig::stats
