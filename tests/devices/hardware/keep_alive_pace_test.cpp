// The DK2's numbers: it sleeps 10 s after the last report that it took, keep-alives are due every
// 3 s, and the kernel gives up on a lost one after 5 s.
#include "devices/hardware/keep_alive_pace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace foverig::hardware {
namespace {

constexpr Nanoseconds kPeriod{3'000'000'000}, kSleepsAfter{10'000'000'000};
constexpr Nanoseconds kLostAfter{5'000'000'000}, kStall{1'000'000}, kBetweenReads{50'000'000};

enum class Fate { taken, lost, stalled };

HostTime at_s(double s) {
    return HostTime(from_seconds(s));
}

/// A reader that looks every 50 ms, and what it tried.
class Reader {
  public:
    Reader() { pace_.set_period(kPeriod); }

    /// `fate` of the n-th keep-alive since the reader began.
    void run_to(double end_s, const std::function<Fate(std::size_t)>& fate) {
        while (now_ < at_s(end_s)) {
            if (pace_.due(now_)) keep_alive(fate(tried_.size()));
            now_ += kBetweenReads;
        }
    }
    /// What somebody else sets now.
    void other_set(Fate fate) {
        if (fate == Fate::lost) now_ += kLostAfter;
        if (fate == Fate::taken) take();
        if (fate == Fate::taken) pace_.taken(now_);
    }
    /// The longest that the device went without a report.
    Nanoseconds longest_without() const { return std::max(longest_, now_ - last_taken_); }
    const std::vector<HostTime>& tried() const { return tried_; }
    /// Spent on keep-alives.
    Nanoseconds held_up() const { return held_up_; }

  private:
    void keep_alive(Fate fate) {
        const HostTime asked = now_;
        tried_.push_back(asked);
        if (fate == Fate::taken) {
            take();
            pace_.keep_alive_taken(now_);
            return;
        }
        now_ += fate == Fate::lost ? kLostAfter : kStall;
        held_up_ += now_ - asked;
        pace_.keep_alive_failed(asked, now_);
    }
    void take() {
        longest_ = std::max(longest_, now_ - last_taken_);
        last_taken_ = now_;
    }

    HostTime now_{}, last_taken_{};
    KeepAlivePace pace_{HostTime{}};
    Nanoseconds longest_{}, held_up_{};
    std::vector<HostTime> tried_;
};

TEST(KeepAlivePace, SendsOneAPeriodAfterWhatTheDeviceTookLast) {
    Reader reader;
    reader.run_to(2.0, [](std::size_t) { return Fate::taken; });
    EXPECT_TRUE(reader.tried().empty());
    reader.other_set(Fate::taken);
    reader.run_to(11.02, [](std::size_t) { return Fate::taken; });
    EXPECT_EQ(reader.tried(), (std::vector{at_s(5), at_s(8), at_s(11)}));
}

TEST(KeepAlivePace, LosesOneAndIsBackBeforeTheHeadsetSleeps) {
    for (std::size_t lost = 0; lost < 4; ++lost) {
        Reader reader;
        reader.run_to(60.0, [=](std::size_t n) { return n == lost ? Fate::lost : Fate::taken; });
        EXPECT_LT(reader.longest_without(), kSleepsAfter) << lost;
    }
    Reader every_second;
    every_second.run_to(120.0, [](std::size_t n) { return n % 2 == 0 ? Fate::lost : Fate::taken; });
    EXPECT_LT(every_second.longest_without(), kSleepsAfter);
}

TEST(KeepAlivePace, SendsOneAtOnceWhereAnothersRequestWasLost) {
    Reader reader;
    const auto taken = [](std::size_t) { return Fate::taken; };
    reader.run_to(2.99, taken);
    reader.other_set(Fate::lost);
    reader.run_to(20.0, taken);
    EXPECT_LT(reader.longest_without(), kSleepsAfter);
    EXPECT_LE(reader.tried().at(0), at_s(8.1));
}

TEST(KeepAlivePace, RestsWithADeviceThatLosesAll) {
    Reader reader;
    reader.run_to(44.0, [](std::size_t) { return Fate::lost; });
    // 3 + 5, at once + 5, a rest of 5, 5, a rest of 20.
    ASSERT_EQ(reader.tried().size(), 4U);
    EXPECT_LT(reader.tried()[1] - at_s(8), 2 * kBetweenReads);
    EXPECT_GE(reader.tried()[2] - reader.tried()[1], 2 * kLostAfter);
    EXPECT_GE(reader.tried()[3] - reader.tried()[2], 5 * kLostAfter);
    reader.run_to(4000.0, [](std::size_t) { return Fate::lost; });
    EXPECT_LT(to_seconds(reader.held_up()), 0.06 * 4000.0);
}

TEST(KeepAlivePace, AsksOneThatRefusesSoonAPeriodLater) {
    Reader reader;
    reader.run_to(10.0, [](std::size_t) { return Fate::stalled; });
    ASSERT_EQ(reader.tried().size(), 3U) << "three tries a time-out";
    EXPECT_LT(reader.tried()[2], at_s(9.5));
}

}  // namespace
}  // namespace foverig::hardware
