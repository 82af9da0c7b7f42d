#pragma once
// How far a sweep is, on stderr: one line that is rewritten on a terminal, a plain line now and
// then elsewhere.
#include <array>
#include <string>

#include "devices/time.h"
#include "rig/sweep/jobs.h"

namespace foverig::sweep {

class TimeLeft {
  public:
    /// No jobs: how many there are nobody knows before.
    explicit TimeLeft(const std::vector<Job>& jobs);
    ~TimeLeft();
    TimeLeft(const TimeLeft&) = delete;
    TimeLeft& operator=(const TimeLeft&) = delete;

    /// Something long that is no run.
    void note(const std::string& what);
    /// A line that stays.
    void tell(const std::string& line);
    void begin(const Job& job);
    void done(const Job& job);

  private:
    struct Kind {
        std::size_t left = 0, done = 0;
        double seconds = 0.0;
    };
    Kind& kind_of(const Job& job) { return kinds_[job.repetition < 0 ? 0 : 1]; }
    double seconds_left() const;
    void show(const std::string& line, bool now);

    WallClock clock_;
    bool on_terminal_;
    std::array<Kind, 2> kinds_;  ///< accuracy and times: their runs do not take alike long
    HostTime began_{}, next_{};
};

}  // namespace foverig::sweep
