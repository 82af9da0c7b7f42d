#include "devices/dk2/stamp_unwrapper.h"

namespace foverig::dk2 {

StampUnwrapper::Verdict StampUnwrapper::advance(std::uint32_t stamp_us) {
    if (!started_) {
        started_ = true;
        now_us_ = stamp_us;
        return Verdict::accepted;
    }
    const std::uint32_t ahead_us = stamp_us - static_cast<std::uint32_t>(now_us_);
    if (restart_expected_) {
        restart_expected_ = false;
        backwards_in_order_ = 0;
        now_us_ += ahead_us > 0 ? std::int64_t{ahead_us} : std::int64_t{1} << 32;
        return Verdict::restarted;
    }
    if (ahead_us == 0) return Verdict::duplicate;
    if (ahead_us < 1u << 31) {
        now_us_ += ahead_us;
        backwards_in_order_ = 0;
        return Verdict::accepted;
    }
    // Old reports come singly or in a short burst; a device that started again keeps counting up.
    const std::uint32_t since_last = stamp_us - last_backwards_us_;
    const bool in_order = backwards_in_order_ > 0 && since_last > 0 && since_last < 1u << 20;
    backwards_in_order_ = in_order ? backwards_in_order_ + 1 : 1;
    last_backwards_us_ = stamp_us;
    if (backwards_in_order_ < kRestartAfter) return Verdict::backwards;
    backwards_in_order_ = 0;
    now_us_ += ahead_us;
    return Verdict::restarted;
}

Dk2Time StampUnwrapper::near(std::uint32_t stamp_us) const {
    const std::uint32_t ahead_us = stamp_us - static_cast<std::uint32_t>(now_us_);
    const std::int64_t offset_us = ahead_us <= 1u << 24
                                       ? std::int64_t{ahead_us}
                                       : std::int64_t{ahead_us} - (std::int64_t{1} << 32);
    return Dk2Time(Nanoseconds((now_us_ + offset_us) * 1000));
}

}  // namespace foverig::dk2
