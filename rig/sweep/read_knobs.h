#pragma once
#include <toml++/toml.h>
#include <filesystem>
#include <vector>

#include "rig/sweep/definition.h"

namespace foverig::sweep {

/// The table [knobs]: scenario keys with lists of values or ranges, in the order of the file, but
/// the foveation's configuration first, since what it sets may be a knob of its own. Throws
/// UsageError, also where there is none.
std::vector<Knob> read_knobs(const std::filesystem::path& file, const toml::table* table);

}  // namespace foverig::sweep
