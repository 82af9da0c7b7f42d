#pragma once
#include <string>

namespace foverig::bench {

/// Makes, builds and renders the scene of that name, or loads the file, and prints one line of
/// JSON; what a large scene costs is measured in a process of its own, whose peak memory is nobody
/// else's.
int run_large_scene(const std::string& name_or_file);

}  // namespace foverig::bench
