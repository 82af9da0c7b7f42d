#pragma once
// What the HUD knows of a run: its newest frames, and what was lost since it was opened.
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "rig/records/frame_record.h"

namespace foverig {

class RecentFrames {
  public:
    static constexpr std::size_t kShown = 240;

    void add(const FrameRecord& frame);

    /// Oldest first, at most kShown.
    const std::vector<float>& frame_ms() const { return frame_ms_; }
    std::optional<double> motion_to_photon_ms() const { return motion_to_photon_ms_; }
    std::optional<double> warp_to_photon_ms() const { return warp_to_photon_ms_; }
    std::optional<double> gaze_to_photon_ms() const { return gaze_to_photon_ms_; }
    /// Absent: no camera sees through.
    std::optional<double> see_through_to_photon_ms() const { return see_through_to_photon_ms_; }
    std::uint64_t dropped() const { return dropped_; }    ///< frames that no VSync showed
    std::uint64_t repeated() const { return repeated_; }  ///< VSyncs that showed an older frame
    /// Of each eye, in its own frame.
    const std::array<vec3, 2>& gaze() const { return gaze_; }

  private:
    std::vector<float> frame_ms_;
    std::optional<double> motion_to_photon_ms_, warp_to_photon_ms_, gaze_to_photon_ms_,
        see_through_to_photon_ms_;
    std::uint64_t dropped_ = 0, repeated_ = 0;
    std::optional<std::uint64_t> last_vsync_;
    std::array<vec3, 2> gaze_{vec3(0.0F, 0.0F, -1.0F), vec3(0.0F, 0.0F, -1.0F)};
};

}  // namespace foverig
