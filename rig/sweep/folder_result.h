#pragma once
#include <filesystem>

namespace foverig::sweep {

/// pareto.json and pareto.html of a sweep's folder, from what all its processes have measured.
/// Returns the page. Throws InputError where points are missing, naming them, and as read_measured.
std::filesystem::path write_result(const std::filesystem::path& folder);

}  // namespace foverig::sweep
