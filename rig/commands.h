#pragma once
// What the subcommands do once their options are known.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rig/failure.h"
#include "rig/records/fail_if.h"
#include "rig/scenario/scenario.h"

namespace foverig {

struct RunRequest {
    Scenario scenario;
    std::optional<std::filesystem::path> out;
    std::vector<FailIf> checks;
    bool json = false;  ///< last line of stdout: the summary
};
ExitCode run_command(const RunRequest& request);

struct PlanRequest {
    Scenario scenario;
    bool measure = true;  ///< render a few frames, so that effects have a cost
    bool json = false;
};
ExitCode plan_command(const PlanRequest& request);

/// Makes report.html of each run folder again, from its records alone.
ExitCode report_command(const std::vector<std::filesystem::path>& runs);

ExitCode scenes_command();
ExitCode devices_command();
ExitCode doctor_command();

}  // namespace foverig
