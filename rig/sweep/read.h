#pragma once
#include <filesystem>

#include "rig/sweep/definition.h"

namespace foverig::sweep {

/// A sweep from its TOML file (docs/sweeps.md). Throws UsageError, one sentence with file and line.
Sweep read_sweep(const std::filesystem::path& file);

}  // namespace foverig::sweep
