#pragma once
// Where a recording says that the eyes looked: not the truth, but what a tracker made worse in a
// replay can be judged by.
#include <array>
#include <optional>
#include <vector>

#include "devices/math.h"
#include "devices/time.h"
#include "simulators/replay/recording.h"

namespace foverig {

class RecordedGaze {
  public:
    /// Reads the recording's gaze tracker to its end, as a replay that begins at `start` does;
    /// `loop`: one that begins again at the end.
    RecordedGaze(const Recording& recording, HostTime start, bool loop);

    /// Of each eye in the head's frame, between the samples on either side; none where these lie
    /// further apart than a blink's edge (50 ms), or an eye was not seen.
    std::optional<std::array<dvec3, 2>> at(HostTime time) const;

  private:
    struct Seen {
        HostTime time;
        std::array<dvec3, 2> direction;
    };
    std::vector<Seen> seen_;  // in order of time
    HostTime first_;
    std::optional<Nanoseconds> round_;
};

}  // namespace foverig
