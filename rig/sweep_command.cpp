#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "rig/commands.h"
#include "rig/interrupt.h"
#include "rig/open_scene.h"
#include "rig/require_devices.h"
#include "rig/sweep/folder_result.h"
#include "rig/sweep/header.h"
#include "rig/sweep/journal.h"
#include "rig/sweep/merged.h"
#include "rig/sweep/prices.h"
#include "rig/sweep/read.h"
#include "rig/sweep/time_left.h"
#include "rig/sweep_folder.h"
#include "rig/sweep_runs.h"

namespace foverig {
namespace fs = std::filesystem;
namespace {

/// False where Ctrl-C came first.
bool measure(const std::vector<sweep::Job>& jobs, sweep::Journal& journal, SweepRuns& runs,
             sweep::TimeLeft& left) {
    for (const sweep::Job& job : jobs) {
        left.begin(job);
        try {
            journal.append(job.repetition < 0 ? to_json(runs.accuracy(job.point))
                                              : to_json(runs.times(job.point, job.repetition)));
        } catch (const SweepRuns::Stopped&) {
            return false;
        }
        left.done(job);
    }
    return true;
}

ExitCode tell(const fs::path& folder, bool json) {
    const sweep::Measured measured = sweep::read_measured(folder);
    if (const auto missing = measured.missing(); !missing.empty()) {
        fmt::print("measured: {} of {} points; once all shards are done: foverig report {}\n",
                   measured.points() - missing.size(), measured.points(), folder.string());
        return ExitCode::good;
    }
    const fs::path page = sweep::write_result(folder);
    fmt::print("front and plot: {}\n", fs::absolute(page).lexically_normal().string());
    if (json)
        fmt::print("{}\n", nlohmann::json::parse(std::ifstream(folder / "pareto.json")).dump());
    for (const auto& [point, accuracy] : measured.accuracies) {
        if (accuracy.nan == 0) continue;
        fmt::print(stderr, "not valid: kernels met NaN {} times at point {}; please report it\n",
                   accuracy.nan, point);
        return ExitCode::internal;
    }
    return ExitCode::good;
}

}  // namespace

ExitCode sweep_command(const SweepRequest& request) {
    sweep::Sweep sweep = sweep::read_sweep(request.file);
    require_devices(sweep.base);
    for (const sweep::Point& point : sweep.points) require_scene(point.scenario);
    if (sweep.prices)
        sweep::add_price_points(sweep, EffectPlan(*open_scene(sweep.base), sweep.base.render));
    const fs::path folder = request.out.value_or(fs::path("runs") / sweep.name);
    make_folder(folder);
    const fs::path file = folder / sweep::journal_name(request.shard);
    const std::string program = program_digest();
    const auto header = sweep::header_json(sweep, build_info(), host_info(), program);
    {
        sweep::Journal journal(file);
        begin_or_go_on(journal, file, header);
        std::vector<sweep::Job> jobs = sweep::jobs_of(sweep, request.shard);
        const std::size_t all = jobs.size();
        std::erase_if(jobs, [&](const sweep::Job& job) { return journal.content().has(job); });
        fmt::print(
            stderr, "{} points, {} runs in {}{}\n", sweep.points.size(), all, file.string(),
            jobs.size() < all ? fmt::format(", {} of them done before", all - jobs.size()) : "");
        const Interrupt interrupt;
        sweep::TimeLeft left(jobs);
        SweepRuns runs(sweep, folder, program,
                       {.stop_requested = [&] { return interrupt.requested(); },
                        .note = [&](const std::string& what) { left.note(what); }});
        if (!measure(jobs, journal, runs, left)) {
            fmt::print("ended early; the same command goes on where it was\n");
            return ExitCode::good;
        }
    }
    return tell(folder, request.json);
}

}  // namespace foverig
