#pragma once
// Latency by phase of motion: right after a movement begins, when no prediction can know of it, and
// later (after Warburton et al. 2022, who found 21 to 42 ms at onset and 2 to 13 ms later in four
// headsets).
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "rig/records/frame_record.h"

namespace foverig {

inline constexpr double kHeadMoves_deg_s = 10.0;  ///< from this speed on
inline constexpr double kEyesMove_deg_s = 30.0;   ///< as GazeFilterConfig::saccade_deg_s
inline constexpr double kOnset_ms = 100.0;        ///< so long after a movement began

enum class Phase { rest, onset, steady };

/// Of the head at each frame's photon: onset until kOnset_ms after it began to move, steady while
/// it moves on, else rest. Its speed is the truth's or, where nobody knows that, of the rendered
/// poses.
std::vector<Phase> head_phases(const std::vector<FrameRecord>& frames);

/// Of the eyes: onset until kOnset_ms after a saccade began, else steady. Their speed is that of
/// the best known gaze from frame to frame or, where that is not known, what the tracker's filter
/// found.
std::vector<Phase> gaze_phases(const std::vector<FrameRecord>& frames);

/// Distributions of latency, lag and error in each phase, with the definition's numbers.
nlohmann::json latency_by_phase_json(const std::vector<FrameRecord>& frames);

}  // namespace foverig
