#pragma once
#include <filesystem>
#include <string>

namespace foverig::hardware {

/// What sysfs and procfs keep one value a file in; empty where there is no such file.
std::string first_line_of(const std::filesystem::path& file);

}  // namespace foverig::hardware
