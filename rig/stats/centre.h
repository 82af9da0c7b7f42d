#pragma once
#include <span>

namespace foverig::stats {

/// Of at least one number.
double mean_of(std::span<const double> numbers);
double median_of(std::span<const double> numbers);

}  // namespace foverig::stats
