#pragma once

namespace foverig {

/// While it lives, the first Ctrl-C (SIGINT) or SIGTERM only asks the run to end; a second one ends
/// the program at once. One at a time: signals belong to the process.
class Interrupt {
  public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    bool requested() const;
};

}  // namespace foverig
