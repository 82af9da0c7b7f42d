#include <fmt/format.h>

#include <algorithm>

#include "rig/commands.h"
#include "rig/compare/comparable.h"
#include "rig/compare/exactly.h"
#include "rig/compare/read_runs.h"
#include "rig/compare/told.h"

namespace foverig {
namespace {

using Json = nlohmann::ordered_json;
using Runs = std::vector<report::RunData>;

bool at_fixed_cost(const report::RunData& run) {
    return run.summary.value("fixed_cost", false);
}

ExitCode compare_exactly(const Runs& all, bool json) {
    for (const report::RunData& run : all) {
        const auto difference = compare::first_difference(all.front(), run);
        if (!difference) continue;
        fmt::print("different: {} and {}, {}\n", all.front().folder.string(), run.folder.string(),
                   *difference);
        if (json)
            fmt::print("{}\n", Json{{"verdict", "different"}, {"difference", *difference}}.dump());
        return ExitCode::different;
    }
    const std::string digest = compare::digest_of(all.front());
    fmt::print("same: frames.csv and images of all {} runs, byte for byte ({})\n", all.size(),
               digest);
    if (json) fmt::print("{}\n", Json{{"verdict", "same"}, {"digest", digest}}.dump());
    return ExitCode::good;
}

ExitCode compare_statistically(const Runs& base, const Runs& fresh, const CompareRequest& request) {
    const auto comparison = compare::compare_times(base, fresh, request.times);
    const auto passes = compare::pass_shifts(base, fresh, comparison, request.times.paired);
    fmt::print("{}", compare::told(comparison, request.times, passes));
    if (request.json)
        fmt::print("{}\n", compare::to_json(comparison, request.times, passes).dump());
    return comparison.judgement.verdict == stats::Verdict::worse ? ExitCode::check_failed
                                                                 : ExitCode::good;
}

}  // namespace

ExitCode compare_command(const CompareRequest& request) {
    const Runs base = compare::read_runs(request.base);
    const Runs fresh = compare::read_runs(request.fresh);
    Runs all = base;
    all.insert(all.end(), fresh.begin(), fresh.end());
    compare::check_comparable(all, request.allowed);
    const auto fixed = std::count_if(all.begin(), all.end(), at_fixed_cost);
    if (fixed == 0) return compare_statistically(base, fresh, request);
    if (fixed == static_cast<std::ptrdiff_t>(all.size())) return compare_exactly(all, request.json);
    throw UsageError(
        "some of the runs are at fixed cost and some are measured; expected all of one kind");
}

}  // namespace foverig
