#pragma once
#include "rig/sweep/definition.h"

namespace foverig::sweep {

/// The part of a sweep that one process does: points i, i + n, i + 2n, ...
struct Shard {
    std::size_t index = 0;
    std::size_t count = 1;
};

/// Throws UsageError where the text is not "i/n" with 0 <= i < n <= 10000.
Shard parse_shard(const std::string& text);

/// One run of one point.
struct Job {
    std::size_t point = 0;
    int repetition = -1;  ///< < 0: for its accuracy, not timed

    bool operator==(const Job&) const = default;
};

/// First each point's accuracy, then repetition by repetition all points' times, so that no point's
/// runs lie together. At fixed cost there are no times to measure.
std::vector<Job> jobs_of(const Sweep& sweep, const Shard& shard);

}  // namespace foverig::sweep
