#pragma once
#include <optional>
#include <string>
#include <vector>

#include "rig/report/run_data.h"

namespace foverig::compare {

/// frames.csv and all images of a run at fixed cost, which depend on nothing but the scenario and
/// the program.
std::string digest_of(const report::RunData& run);

/// Where two such runs differ first ("frames.csv: rays_shadow of frame 3 is 1200 and 1201"); no
/// value where not a byte does.
std::optional<std::string> first_difference(const report::RunData& a, const report::RunData& b);

}  // namespace foverig::compare
