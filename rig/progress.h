#pragma once
#include <string>

#include "devices/recording/recorder.h"
#include "devices/time.h"
#include "rig/session/session.h"

namespace foverig {

/// How far a run or a recording is, on stderr: one line that is rewritten on a terminal, a plain
/// line every few seconds elsewhere.
class Progress {
  public:
    Progress();
    void show(const SessionProgress& progress);
    /// What came before `until` of the run's clock was given to the recorder.
    void show(HostTime until, const RecorderCounts& counts);
    /// A line of its own, at once.
    void say(const std::string& text);
    /// Ends the rewritten line.
    void done();

  private:
    void put(const std::string& line);

    WallClock clock_;
    bool on_terminal_;
    bool line_open_ = false;
    HostTime next_{};
};

}  // namespace foverig
