#pragma once
#include <cstdint>
#include <optional>

#include "rig/stats/shift.h"

namespace foverig::stats {

enum class Verdict { better, worse, same, cannot_tell };
const char* name_of(Verdict verdict);

struct Judgement {
    Verdict verdict = Verdict::cannot_tell;
    /// About how many runs a side would tell, the interval shrinking with their square root;
    /// absent: the verdict stands, or more than kMostRuns since the shift lies on the threshold.
    std::optional<std::uint64_t> runs_needed;
};
inline constexpr std::uint64_t kMostRuns = 1000;

/// Of something that should be small. The interval decides: all of it above the threshold is worse,
/// all below its negative better, all between the two the same. `least_runs` a side have an
/// interval.
Judgement judge(const Shift& shift, double threshold, std::size_t least_runs);

}  // namespace foverig::stats
