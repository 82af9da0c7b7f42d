#include "rig/session/run_clock.h"

namespace foverig {

RunClock::RunClock(const std::string& kind, const Cost& cost, double speed) : cost_(cost) {
    if (kind == "wall") {
        clock_ = std::make_unique<WallClock>(speed);
    } else {
        auto manual = std::make_unique<ManualClock>();
        manual_ = manual.get();
        clock_ = std::move(manual);
    }
}

void RunClock::end_work(double fixed_share) {
    const HostTime now = stopwatch_.now();
    if (manual_ != nullptr) {
        manual_->advance(cost_.fixed_ms ? from_seconds(*cost_.fixed_ms * 1e-3 * fixed_share)
                                        : now - work_began_);
    }
    work_began_ = now;
}

}  // namespace foverig
