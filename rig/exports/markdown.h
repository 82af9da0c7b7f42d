#pragma once
#include <string>

#include "rig/report/run_data.h"

namespace foverig::exports {

/// A run's summary for a CI job's page: what ran, its times with intervals, what it missed, what
/// its effects cost. GitHub's Markdown.
std::string markdown(const report::RunData& run);

}  // namespace foverig::exports
