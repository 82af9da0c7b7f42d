#pragma once
#include <filesystem>
#include <vector>

#include "rig/report/run_data.h"

namespace foverig::compare {

/// Run folders as they were written; a folder that is none stands for the run folders in it, in the
/// order of their names. Throws InputError for what is neither, and for runs that say nothing:
/// without frames, ended early, or with NaN in their images; UsageError for one that is named
/// twice.
std::vector<report::RunData> read_runs(const std::vector<std::filesystem::path>& places);

}  // namespace foverig::compare
