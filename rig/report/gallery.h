#pragma once
#include <string>

#include "rig/report/run_data.h"

namespace foverig::report {

/// The kept images, embedded and small enough that all of them take at most `most_bytes`.
std::string gallery(const RunData& run, std::size_t most_bytes);

}  // namespace foverig::report
