#pragma once
// frames.csv, written and read. Comma separated, one header line, NA for what is absent.
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "rig/records/frame_record.h"

namespace foverig {

/// Without wall times the text depends on the scenario alone (lockstep clock at a fixed cost).
enum class WallTimes { keep, omit };
std::string frames_csv(const std::vector<FrameRecord>& frames, WallTimes wall_times);

/// The columns of a frames.csv, by id; all of the same length.
struct FrameTable {
    std::size_t frames = 0;
    std::map<std::string, std::vector<std::optional<double>>> columns;
    std::vector<std::string> order;  ///< ids as they stand in the file

    /// Empty cells for an unknown id.
    std::vector<std::optional<double>> column(const std::string& id) const;
};

/// Throws InputError with file and line.
FrameTable read_frames_csv(const std::filesystem::path& file);

}  // namespace foverig
