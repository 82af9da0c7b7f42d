#pragma once
#include "devices/time.h"
#include "rig/session/session.h"

namespace foverig {

/// How far a run is, on stderr: one line that is rewritten on a terminal, a plain line every few
/// seconds elsewhere.
class Progress {
  public:
    Progress();
    void show(const SessionProgress& progress);
    /// A line of its own, at once.
    void say(const std::string& text);
    /// Ends the rewritten line.
    void done();

  private:
    WallClock clock_;
    bool on_terminal_;
    bool line_open_ = false;
    HostTime next_{};
};

}  // namespace foverig
