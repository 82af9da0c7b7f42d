#include <fmt/format.h>

#include <system_error>

#include "rig/commands.h"
#include "rig/exports/benchmark_json.h"
#include "rig/exports/formats.h"
#include "rig/output/run_folder.h"
#include "rig/report/page.h"
#include "rig/sweep/folder_result.h"
#include "rig/sweep/merged.h"

namespace foverig {
namespace fs = std::filesystem;
namespace {

void say(const char* what, const fs::path& file) {
    fmt::print("{}: {}\n", what, fs::absolute(file).lexically_normal().string());
}

void report_run(const report::RunData& run, const std::vector<std::string>& exports) {
    replace_text(run.folder / "report.html", report::page(run));
    say("report", run.folder / "report.html");
    for (const std::string& name : exports) {
        const exports::Format& format = exports::format_of(name);
        replace_text(run.folder / format.file, format.text(run));
        say("export", run.folder / format.file);
    }
}

void write_together(const fs::path& file, const std::vector<report::RunData>& runs) {
    const std::string text = exports::benchmark_json(runs).dump(2) + "\n";
    try {
        replace_text(file, text);
    } catch (const std::system_error& error) {
        const bool full = error.code() == std::errc::no_space_on_device ||
                          error.code() == std::errc::file_too_large;
        if (full) throw;  // another command line would not help
        throw UsageError(fmt::format("--together {}", error.what()));
    }
}

}  // namespace

ExitCode report_command(const ReportRequest& request) {
    std::vector<report::RunData> runs;
    for (const fs::path& folder : request.runs) {
        if (!sweep::is_sweep(folder)) {
            runs.push_back(report::read_run(folder));
            report_run(runs.back(), request.exports);
        } else if (request.exports.empty() && !request.together) {
            say("report", sweep::write_result(folder));
        } else {
            throw UsageError(
                fmt::format("{}: is a sweep; expected run folders to export", folder.string()));
        }
    }
    if (request.together) {
        write_together(*request.together, runs);
        say("export", *request.together);
    }
    return ExitCode::good;
}

}  // namespace foverig
