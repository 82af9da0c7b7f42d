#pragma once
// What the subcommands do once their options are known.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rig/compare/times.h"
#include "rig/diff_metrics.h"
#include "rig/failure.h"
#include "rig/records/fail_if.h"
#include "rig/scenario/scenario.h"
#include "rig/sweep/jobs.h"

namespace foverig {

struct RunRequest {
    Scenario scenario;
    std::optional<std::filesystem::path> out;
    std::vector<FailIf> checks;
    bool json = false;  ///< last line of stdout: the summary
};
ExitCode run_command(const RunRequest& request);

struct RecordRequest {
    Scenario scenario;
    std::optional<std::filesystem::path> out;  ///< none: the next free recordings/NNN.mcap
};
/// The devices' streams alone, into one file.
ExitCode record_command(const RecordRequest& request);

/// The scenario that a recording was made with, its devices replayed. Throws InputError.
Scenario recorded_scenario(const std::filesystem::path& recording);

/// Mends a torn recording into `out` (none: FILE.recovered.mcap beside it), says what was lost.
ExitCode recover_command(const std::filesystem::path& recording,
                         const std::optional<std::filesystem::path>& out);

struct PlanRequest {
    Scenario scenario;
    bool measure = true;  ///< render a few frames, so that effects have a cost
    bool json = false;
};
ExitCode plan_command(const PlanRequest& request);

struct ReportRequest {
    std::vector<std::filesystem::path> runs;
    std::vector<std::string> exports;               ///< names of exports::formats()
    std::optional<std::filesystem::path> together;  ///< Google Benchmark JSON of all runs
};
/// Makes report.html of each run folder again, from its records alone; of a sweep's folder
/// pareto.json and pareto.html.
ExitCode report_command(const ReportRequest& request);

struct DiffRequest {
    std::filesystem::path reference, test;  ///< two images, or two folders of frames
    DiffSettings settings;
    std::optional<std::filesystem::path> heatmap;  ///< PNG to write
    bool json = false;                             ///< last line of stdout: all of it
};
ExitCode diff_command(const DiffRequest& request);

struct CompareRequest {
    std::vector<std::filesystem::path> base, fresh;  ///< run folders, or folders of them
    compare::TimeSettings times;
    std::vector<std::string> allowed;  ///< keys that may differ
    bool json = false;                 ///< last line of stdout: all of it
};
ExitCode compare_command(const CompareRequest& request);

struct SweepRequest {
    std::filesystem::path file;
    std::optional<std::filesystem::path> out;  ///< none: runs/NAME
    sweep::Shard shard;
    bool json = false;  ///< last line of stdout: pareto.json
};
/// Measures what is not measured yet; makes the result once nothing is missing.
ExitCode sweep_command(const SweepRequest& request);

struct TuneRequest {
    std::filesystem::path file;
    std::optional<std::filesystem::path> out;  ///< none: runs/NAME-tuned
    std::optional<double> budget_ms;           ///< none: a VSync of the base scenario
    bool json = false;                         ///< last line of stdout: tuned.json
};
/// Searches a sweep's grid for the smallest error within a budget; writes it as a scenario.
ExitCode tune_command(const TuneRequest& request);

ExitCode scenes_command();
ExitCode devices_command();
ExitCode doctor_command();

}  // namespace foverig
