#include "rig/compare/times.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "rig/failure.h"
#include "rig/records/elsewhere.h"
#include "rig/stats/centre.h"
#include "rig/stats/warm_up.h"
#include "rig/text/nearest.h"

namespace foverig::compare {
namespace {

std::vector<double> values_of(const report::RunData& run, const std::string& column,
                              std::size_t from) {
    std::vector<double> values;
    const auto cells = run.frames.column(column);
    for (std::size_t i = from; i < cells.size(); ++i)
        if (cells[i]) values.push_back(*cells[i]);
    return values;
}

std::size_t warm_up_of(const std::vector<report::RunData>& runs) {
    std::size_t most = 0;
    for (const report::RunData& run : runs)
        most = std::max(most, stats::warm_up_count(values_of(run, "frame_time_ms", 0)));
    return most;
}

std::optional<double> most_elsewhere(const std::vector<report::RunData>& runs) {
    std::optional<double> most;
    for (const report::RunData& run : runs)
        if (const auto processors = elsewhere_processors(run.summary))
            most = std::max(most.value_or(0.0), *processors);
    return most;
}

void check_column(const report::RunData& run, const std::string& column) {
    const auto& known = run.frames.order;
    if (std::find(known.begin(), known.end(), column) == known.end())
        throw UsageError(fmt::format("--of {}: no column of {}; the nearest is {}", column,
                                     (run.folder / "frames.csv").string(), nearest(column, known)));
}

stats::Shift scaled(stats::Shift shift, double by) {
    shift.value *= by;
    if (shift.ci95) shift.ci95 = stats::Interval{shift.ci95->low * by, shift.ci95->high * by};
    return shift;
}

}  // namespace

std::vector<double> medians_of(const std::vector<report::RunData>& runs, const std::string& column,
                               std::size_t from) {
    std::vector<double> medians;
    for (const report::RunData& run : runs) {
        const auto values = values_of(run, column, from);
        if (values.empty())
            throw InputError(fmt::format("{}: has no value of {} beyond the warm-up",
                                         run.folder.string(), column));
        medians.push_back(stats::median_of(values));
    }
    return medians;
}

TimeComparison compare_times(const std::vector<report::RunData>& base,
                             const std::vector<report::RunData>& fresh,
                             const TimeSettings& settings) {
    for (const auto* side : {&base, &fresh})
        for (const report::RunData& run : *side) check_column(run, settings.of);
    if (settings.paired && base.size() != fresh.size())
        throw UsageError(fmt::format("--paired: {} runs against {}; expected as many on both sides",
                                     base.size(), fresh.size()));
    TimeComparison c;
    c.warm_up_frames = std::max(warm_up_of(base), warm_up_of(fresh));
    c.elsewhere_processors = std::max(most_elsewhere(base), most_elsewhere(fresh));
    c.base = medians_of(base, settings.of, c.warm_up_frames);
    c.fresh = medians_of(fresh, settings.of, c.warm_up_frames);
    c.shift = settings.paired ? stats::paired_shift(c.base, c.fresh)
                              : stats::shift_between(c.base, c.fresh);
    const double level = stats::median_of(c.base);
    if (!(level > 0.0))
        throw InputError(
            fmt::format("{}: the median of {} is {}; expected more than 0 to compare with",
                        base.front().folder.string(), settings.of, level));
    c.relative = scaled(c.shift, 1.0 / level);
    c.judgement = stats::judge(c.relative, settings.threshold,
                               settings.paired ? stats::kLeastPairs : stats::kLeastRuns);
    return c;
}

}  // namespace foverig::compare
