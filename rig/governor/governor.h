#pragma once
// Which of a few measured settings the next frame is rendered with, so that frames stay below a
// limit. Knows milliseconds and nothing else.
#include <cstddef>
#include <deque>
#include <vector>

namespace foverig::governor {

struct Limits {
    double limit_ms = 0.0;     ///< frames are to stay below
    int patience_frames = 40;  ///< with room for the next dearer setting before it is taken
};

/// Down at once: when a frame is beyond the limit, to the dearest setting that would have stayed
/// below it if it cost in proportion to what was measured, one lower at least. Up one by one: once
/// the next dearer setting would have had room in each of `patience_frames` frames in a row. A step
/// up that had to be taken back within eight times the patience doubles it, eight times at most; a
/// setting that holds for so long halves it again (hysteresis). The first frame after a change has
/// no history of its own and is judged by neither rule.
class Governor {
  public:
    /// What each setting cost where it was measured, cheapest first, all above 0. Starts with the
    /// dearest below the limit.
    Governor(std::vector<double> setting_ms, const Limits& limits);

    std::size_t setting() const { return setting_; }
    std::size_t changes() const { return changes_; }
    /// The frame just rendered took that long.
    void frame_took(double ms);

  private:
    void go_to(std::size_t setting);
    void go_down(double scale);
    void consider_going_up();

    std::vector<double> setting_ms_;
    Limits limits_;
    std::size_t setting_ = 0;
    std::size_t changes_ = 0;
    bool fresh_ = false;         ///< the next frame is the first with this setting
    bool went_up_ = false;       ///< the last change was
    int held_frames_ = 0;        ///< since the last change
    int patience_;               ///< now
    std::deque<double> scales_;  ///< measured by expected, of the last frames
};

}  // namespace foverig::governor
