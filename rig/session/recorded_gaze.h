#pragma once
// Where a recording says that the eyes looked: not the truth, but what a tracker made worse in a
// replay can be judged by.
#include <array>
#include <memory>
#include <optional>

#include "devices/math.h"
#include "devices/time.h"
#include "simulators/replay/recording.h"

namespace foverig {

class RecordedGaze {
  public:
    /// Reads the recording's gaze tracker as a replay that begins at `start` does, no further than
    /// it is asked for; `loop`: of one that begins again at the end. At the rate that was recorded.
    RecordedGaze(const Recording& recording, HostTime start, bool loop);
    ~RecordedGaze();

    /// Of each eye in the head's frame, between the samples on either side; none where these lie
    /// further apart than a blink's edge (50 ms), or an eye was not seen.
    std::optional<std::array<dvec3, 2>> at(HostTime time) const;

  private:
    class Reader;

    std::unique_ptr<Reader> reader_;  // only reads on: what it gives of a time stays the same
    HostTime first_;
    std::optional<Nanoseconds> round_;
};

}  // namespace foverig
