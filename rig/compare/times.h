#pragma once
#include <optional>
#include <string>
#include <vector>

#include "rig/report/run_data.h"
#include "rig/stats/verdict.h"

namespace foverig::compare {

struct TimeSettings {
    std::string of = "frame_time_ms";  ///< a column of frames.csv of which less is better
    double threshold = 0.03;           ///< share of the base's median that matters
    bool paired = false;               ///< the i-th runs of both sides were made together
};

struct TimeComparison {
    std::size_t warm_up_frames = 0;   ///< left out of every run: the most that any needs
    std::vector<double> base, fresh;  ///< median of each run
    /// The most of the machine's processors that others had during a run; none: not known.
    std::optional<double> elsewhere_processors;
    stats::Shift shift;     ///< in the column's unit
    stats::Shift relative;  ///< to the median of `base`
    stats::Judgement judgement;
};

/// Of each run, of that column beyond its first `from` frames. Throws InputError for a run without
/// a value there.
std::vector<double> medians_of(const std::vector<report::RunData>& runs, const std::string& column,
                               std::size_t from);

/// The unit is the run: its frames depend on each other. Throws UsageError for a column that is not
/// there and for sides of different length where they are paired.
TimeComparison compare_times(const std::vector<report::RunData>& base,
                             const std::vector<report::RunData>& fresh,
                             const TimeSettings& settings);

}  // namespace foverig::compare
