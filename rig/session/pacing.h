#pragma once
// When a frame begins, and which VSync it can expect to make.
#include <cstddef>
#include <deque>
#include <optional>
#include <string>

#include "devices/display/display.h"

namespace foverig {

class Pacing {
  public:
    /// `kind`: vsync or free (DisplaySettings). `display` outlives this.
    Pacing(const std::string& kind, const Display& display);

    /// When the next frame may begin: no two frames begin at one VSync.
    HostTime wake_up(HostTime now) const;
    /// The first VSync after `begin`: what a frame within budget makes.
    HostTime aimed_vsync(HostTime begin) const;
    /// The VSync that the frame will make if it takes as long as the last ones did.
    HostTime expected_vsync(HostTime begin) const;

    void frame_done(HostTime begin, HostTime present);

  private:
    static constexpr std::size_t kRemembered = 5;  // median: one slow frame does not mislead

    bool waits_;
    const Display& display_;
    std::deque<Nanoseconds> recent_;
    std::optional<HostTime> last_begin_;
};

}  // namespace foverig
