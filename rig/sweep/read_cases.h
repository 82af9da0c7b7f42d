#pragma once
#include "rig/sweep/definition.h"
#include "rig/sweep/toml_reader.h"

namespace foverig::sweep {

/// Sets cases and points from [[cases]] and [[variants]]: every variant of every case, the variants
/// changing fastest. `reference` is the file's [reference], or null. Throws UsageError.
void read_cases(const std::filesystem::path& file, const TomlReader& reader,
                const toml::table* reference, Sweep& sweep);

/// A scenario's settings but for the pipeline, and what [reference] says (null: nothing).
RenderSettings read_reference(const std::filesystem::path& file, const toml::table* table,
                              const Scenario& base);

}  // namespace foverig::sweep
