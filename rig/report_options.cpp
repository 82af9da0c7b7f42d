#include "rig/report_options.h"

#include "rig/exports/formats.h"

namespace foverig {

void ReportOptions::add_to(CLI::App& app) {
    CLI::App& report = *app.add_subcommand(
        "report", "make reports of run folders and sweeps again, from their records");
    std::vector<std::string> names;
    for (const exports::Format& format : exports::formats()) names.push_back(format.name);
    report.add_option("runs", runs_, "run folders, or folders of sweeps")
        ->type_name("RUN...")
        ->required();
    report
        .add_option("--export", exports_,
                    "write these into each run's folder too: trace.pftrace, summary.md, "
                    "benchmark.json, presentmon.csv")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember(names))
        ->type_name("FORMATS");
    report
        .add_option(
            "--together", together_,
            "one Google Benchmark JSON of all these runs, each a repetition, for compare.py")
        ->type_name("FILE");
    report.footer(
        "Examples:\n"
        "  foverig report runs/001 runs/002\n"
        "  foverig report runs/001 --export perfetto,markdown   opens in ui.perfetto.dev\n"
        "  foverig report base/01 base/02 --together base.json\n"
        "  foverig report runs/example      merges the shards of a sweep");
}

ReportRequest ReportOptions::request() const {
    ReportRequest request;
    request.runs = {runs_.begin(), runs_.end()};
    request.exports = exports_;
    if (!together_.empty()) request.together = together_;
    return request;
}

}  // namespace foverig
