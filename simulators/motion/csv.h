#pragma once
// Recorded trajectories: a header line of column names, then numbers. '#' starts a comment line.
#include <filesystem>
#include <string>
#include <vector>

#include "devices/result.h"

namespace foverig::motion {

struct Table {
    std::vector<std::string> columns;
    std::vector<std::vector<double>> rows;  ///< each as long as `columns`
    std::vector<int> lines;                 ///< line of the file that each row stands on
};

/// One sentence with file and line for a file that is absent, has no rows, a row of another
/// length, a cell that is no finite number, or times (first column) that do not increase.
Result<Table> read_trajectory(const std::filesystem::path& file);

}  // namespace foverig::motion
