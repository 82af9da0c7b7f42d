#include "rig/stats/shift.h"

#include <algorithm>
#include <vector>

#include "rig/stats/quantile.h"
#include "rig/stats/rank_tests.h"

namespace foverig::stats {
namespace {

Shift shift_of(std::vector<double> differences, std::size_t depth, std::size_t n) {
    std::sort(differences.begin(), differences.end());
    Shift shift{quantile(differences, 0.5), std::nullopt, n};
    if (depth > 0)
        shift.ci95 = Interval{differences[depth - 1], differences[differences.size() - depth]};
    return shift;
}

}  // namespace

Shift shift_between(std::span<const double> before, std::span<const double> after) {
    std::vector<double> differences;
    for (const double b : before)
        for (const double a : after) differences.push_back(a - b);
    return shift_of(std::move(differences), rank_sum_depth(before.size(), after.size()),
                    std::min(before.size(), after.size()));
}

Shift paired_shift(std::span<const double> before, std::span<const double> after) {
    std::vector<double> walsh;
    for (std::size_t i = 0; i < before.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j)
            walsh.push_back(0.5 * ((after[i] - before[i]) + (after[j] - before[j])));
    return shift_of(std::move(walsh), signed_rank_depth(before.size()), before.size());
}

}  // namespace foverig::stats
