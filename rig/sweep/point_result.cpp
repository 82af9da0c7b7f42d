#include "rig/sweep/point_result.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "rig/stats/bootstrap.h"
#include "rig/stats/centre.h"
#include "rig/stats/student_t.h"

namespace foverig::sweep {
namespace {

std::span<const double> beyond(const std::vector<double>& frames, std::size_t warm_up_frames) {
    return std::span(frames).subspan(std::min(warm_up_frames, frames.size()));
}

double vsyncs_of(double ms, double budget_ms) {
    return std::max(1.0, std::ceil(ms / budget_ms));
}

}  // namespace

std::map<std::string, PointErrors> errors_of(const Accuracy& accuracy, std::size_t warm_up_frames) {
    std::map<std::string, PointErrors> errors;
    for (const auto& [name, frames] : accuracy.errors) {
        const auto values = beyond(frames, warm_up_frames);
        if (values.empty()) continue;
        errors[name] = {{stats::mean_of(values), stats::bootstrap_interval(values, stats::mean_of)},
                        {stats::percentile_of(values, 0.50), stats::percentile_of(values, 0.90)},
                        *std::max_element(values.begin(), values.end())};
    }
    return errors;
}

PointTimes times_of(const std::vector<Times>& runs, std::size_t warm_up_frames, double budget_ms) {
    PointTimes times;
    std::vector<double> frames_ms;
    double vsyncs = 0.0;
    for (const Times& run : runs) {
        const auto values = beyond(run.frame_ms, warm_up_frames);
        if (values.empty()) continue;
        times.runs_ms.push_back(stats::median_of(values));
        frames_ms.insert(frames_ms.end(), values.begin(), values.end());
        for (const double ms : values) vsyncs += vsyncs_of(ms, budget_ms);
        for (const auto& [pass, ms] : run.pass_ms)
            times.pass_ms[pass] += ms / static_cast<double>(runs.size());
    }
    if (frames_ms.empty()) return times;
    times.ms = {stats::mean_of(times.runs_ms), stats::mean_interval(times.runs_ms)};
    times.missed_ratio = 1.0 - static_cast<double>(frames_ms.size()) / vsyncs;
    for (const double share : {0.50, 0.90, 0.99})
        times.percentiles.push_back(stats::percentile_of(frames_ms, share));
    return times;
}

PointTimes modelled_times(double ms, double budget_ms) {
    PointTimes times;
    times.ms.value = ms;
    times.missed_ratio = 1.0 - 1.0 / vsyncs_of(ms, budget_ms);
    return times;
}

}  // namespace foverig::sweep
