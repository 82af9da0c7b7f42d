#include "rig/compare/read_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "rig/failure.h"

namespace foverig::compare {
namespace fs = std::filesystem;
namespace {

bool is_run(const fs::path& folder) {
    return fs::exists(folder / "summary.json");
}

std::vector<fs::path> runs_in(const fs::path& place) {
    if (is_run(place)) return {place};
    if (!fs::is_directory(place))
        throw InputError(
            fmt::format("{}: no such folder; expected a run folder, as `foverig run` "
                        "writes it, or a folder of them",
                        place.string()));
    std::vector<fs::path> runs;
    for (const auto& entry : fs::directory_iterator(place))
        if (is_run(entry.path())) runs.push_back(entry.path());
    if (runs.empty())
        throw InputError(fmt::format(
            "{}: is no run folder and holds none; expected what `foverig run --out` wrote",
            place.string()));
    std::sort(runs.begin(), runs.end());
    return runs;
}

void check_says_something(const report::RunData& run) {
    const std::string name = run.folder.string();
    if (run.frames.frames == 0) throw InputError(fmt::format("{}: has no frames", name));
    if (run.summary.value("interrupted", false))
        throw InputError(
            fmt::format("{}: was ended early; expected whole runs, so make it again", name));
    if (run.number({"numerics", "nan"}).value_or(0.0) > 0.0)
        throw InputError(fmt::format("{}: is not valid, kernels met NaN", name));
}

/// The unit is the run: one that is named twice is one trial, not two.
void check_named_once(const std::vector<report::RunData>& runs) {
    std::set<fs::path> met;
    for (const report::RunData& run : runs)
        if (!met.insert(fs::weakly_canonical(run.folder)).second)
            throw UsageError(
                fmt::format("{}: is named twice; expected runs that were made anew, "
                            "as the same one is no other trial",
                            run.folder.string()));
}

}  // namespace

std::vector<report::RunData> read_runs(const std::vector<fs::path>& places) {
    std::vector<report::RunData> runs;
    for (const fs::path& place : places)
        for (const fs::path& folder : runs_in(place)) {
            runs.push_back(report::read_run(folder));
            check_says_something(runs.back());
        }
    check_named_once(runs);
    return runs;
}

}  // namespace foverig::compare
