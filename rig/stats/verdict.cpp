#include "rig/stats/verdict.h"

#include <algorithm>
#include <cmath>

namespace foverig::stats {

const char* name_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::better:
            return "better";
        case Verdict::worse:
            return "worse";
        case Verdict::same:
            return "same";
        case Verdict::cannot_tell:
            break;
    }
    return "cannot tell";
}

Judgement judge(const Shift& shift, double threshold, std::size_t least_runs) {
    if (!shift.ci95) return {Verdict::cannot_tell, least_runs};
    const Interval& ci = *shift.ci95;
    if (ci.low > threshold) return {Verdict::worse, std::nullopt};
    if (ci.high < -threshold) return {Verdict::better, std::nullopt};
    if (ci.low > -threshold && ci.high < threshold) return {Verdict::same, std::nullopt};
    const double reach = std::max(ci.high - shift.value, shift.value - ci.low);
    const double room = std::abs(std::abs(shift.value) - threshold);
    const double runs = static_cast<double>(shift.n) * (reach / room) * (reach / room);
    if (!(runs <= static_cast<double>(kMostRuns))) return {Verdict::cannot_tell, std::nullopt};
    const auto needed = static_cast<std::uint64_t>(std::ceil(runs - 1e-6));
    return {Verdict::cannot_tell, std::max<std::uint64_t>(needed, shift.n + 1)};
}

}  // namespace foverig::stats
