#pragma once
// What a run folder can be exported to.
#include <string>
#include <vector>

#include "rig/report/run_data.h"

namespace foverig::exports {

struct Format {
    std::string name;  ///< of `foverig report --export`
    std::string file;  ///< in the run's folder
    std::string (*text)(const report::RunData& run);
};

const std::vector<Format>& formats();

/// Throws std::invalid_argument for an unknown name.
const Format& format_of(const std::string& name);

}  // namespace foverig::exports
