#pragma once
#include <cstddef>
#include <span>

namespace foverig::stats {

/// How many leading times are not yet as those of the later half are: they end where, of a stretch
/// of kSteadyStretch, the first and the median lie below median + 3 scaled MADs of that half (or
/// 1 % above its median, if that is more). Only slower is cold: faster frames at the start are
/// the scene's. At most a quarter of the series, and 0 where it would be more: then it is no
/// warm-up. Our own rule.
std::size_t warm_up_count(std::span<const double> times);
inline constexpr std::size_t kSteadyStretch = 5;

}  // namespace foverig::stats
