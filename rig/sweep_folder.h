#pragma once
// What `foverig sweep` and `foverig tune` need to go on with what was begun.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "rig/sweep/journal.h"

namespace foverig {

/// Tells programs apart, also two builds of one commit.
std::string program_digest();

/// Throws UsageError where it cannot be.
void make_folder(const std::filesystem::path& folder);

/// Writes the header into a new file; a file that was begun must be of this sweep, this program and
/// this machine, else throws UsageError.
void begin_or_go_on(sweep::Journal& journal, const std::filesystem::path& file,
                    const nlohmann::json& header);

}  // namespace foverig
