#pragma once
#include <span>

namespace foverig::stats {

/// How many independent numbers know as much of the mean as this series of dependent ones: n over
/// 1 + 2 times the sum of its autocorrelations, which ends where a pair of neighbours falls to 0
/// (initial positive sequence, Geyer 1992). 1..n; n for a series that does not vary.
double effective_count(std::span<const double> series);

}  // namespace foverig::stats
