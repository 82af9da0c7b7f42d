#pragma once
// Eyes that look where they are told to while a run goes on: by a cursor, say.
#include <deque>

#include "simulators/motion/eye_motion.h"

namespace foverig::motion {

/// Each order stands from its time until the next; straight ahead before the first. One thread
/// gives orders and asks.
class PointedEye final : public EyeMotion {
  public:
    /// Orders that are remembered: a tracker asks for exposures of the last frame's time.
    static constexpr std::size_t kHistory = 256;

    /// `t_s` does not go back.
    void look(double t_s, const EyeState& state) {
        orders_.push_back({t_s, state});
        if (orders_.size() > kHistory) orders_.pop_front();
    }

    EyeState at(double t_s) const override {
        for (auto order = orders_.rbegin(); order != orders_.rend(); ++order)
            if (order->from_s <= t_s) return order->state;
        return {};
    }

  private:
    struct Order {
        double from_s;
        EyeState state;
    };
    std::deque<Order> orders_;
};

}  // namespace foverig::motion
