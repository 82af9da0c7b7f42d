#pragma once
#include <cstdint>
#include <vector>

#include "rig/records/frame_record.h"

namespace foverig {

/// What became of frames and VSyncs, from the first shown frame's VSync to the last one's.
/// total == presented + missed, and rendered == presented + dropped.
struct VsyncCount {
    std::uint64_t rendered = 0;
    std::uint64_t presented = 0;      ///< frames that a VSync showed
    std::uint64_t dropped = 0;        ///< frames replaced before any VSync showed them
    std::uint64_t late = 0;           ///< frames that missed the VSync they were begun for
    std::uint64_t mis_presented = 0;  ///< shown at another VSync than their pictures are of
    std::uint64_t total = 0;          ///< VSyncs
    std::uint64_t missed = 0;         ///< VSyncs that repeated an older frame
};

VsyncCount count_vsyncs(const std::vector<FrameRecord>& frames);

}  // namespace foverig
