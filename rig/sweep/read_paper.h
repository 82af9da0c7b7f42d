#pragma once
#include <nlohmann/json.hpp>

#include "rig/sweep/definition.h"
#include "rig/sweep/toml_reader.h"

namespace foverig::sweep {

/// What a paper found of a sweep's cases and variants: {source, conditions, baseline, stages[{name,
/// passes[]}], values[{case, variant, ms, ms_error, mrays, stages_ms[], read}]}. `ms_error` is half
/// the width of what could be read off a plot, null of a printed number; `read` says where a number
/// stands. Throws UsageError where a name is none of the sweep's.
nlohmann::json read_paper(const std::filesystem::path& file, const toml::table& table,
                          const Sweep& sweep);

}  // namespace foverig::sweep
