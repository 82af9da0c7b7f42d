#pragma once
// The run's clock and what a frame costs on it.
#include <memory>
#include <string>

#include "devices/time.h"
#include "rig/scenario/cost.h"

namespace foverig {

/// wall: time passes by itself. lockstep: work takes what it measured, or a fixed time.
class RunClock {
  public:
    /// `kind`: wall or lockstep; `speed` of the wall clock.
    RunClock(const std::string& kind, const Cost& cost, double speed = 1.0);

    Clock& clock() { return *clock_; }
    HostTime now() const { return clock_->now(); }

    /// Start of a stretch of work.
    void start_work() { work_began_ = stopwatch_.now(); }
    /// End of a stretch; on a lockstep clock time moves by what it cost: as measured, or
    /// `fixed_share` of the fixed cost. A new stretch begins.
    void end_work(double fixed_share);

    /// Of the frames from now on; where the cost is measured it stays so.
    void set_fixed_ms(double ms) {
        if (cost_.fixed_ms) cost_.fixed_ms = ms;
    }
    bool fixed_cost() const { return manual_ != nullptr && cost_.fixed_ms.has_value(); }

  private:
    std::unique_ptr<Clock> clock_;
    ManualClock* manual_ = nullptr;  // into clock_, on lockstep
    Cost cost_;
    WallClock stopwatch_;
    HostTime work_began_{};
};

}  // namespace foverig
