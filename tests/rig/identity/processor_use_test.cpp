#include "rig/identity/processor_use.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <ctime>
#include <thread>

namespace foverig {
namespace {

// The example line of proc_stat(5): user nice system idle iowait irq softirq steal guest
// guest_nice. Guests' time is in user's already.
TEST(ProcessorUse, ReadsTheLineOfTheManualPage) {
    const auto times = parse_processor_times(
        "cpu  10132153 290696 3084719 46828483 16683 0 25195 7 175628 0", 100.0);
    ASSERT_TRUE(times);
    EXPECT_DOUBLE_EQ(times->busy_s, 135327.63);
    EXPECT_DOUBLE_EQ(times->idle_s, 468451.66);
    EXPECT_DOUBLE_EQ(times->stolen_s, 0.07);
}

TEST(ProcessorUse, RefusesWhatIsNoSuchLine) {
    for (const char* line : {"", "cpu", "cpu 1 2 3 4 5 6 7", "cpu0 1 2 3 4 5 6 7 8", "intr 1 2"})
        EXPECT_FALSE(parse_processor_times(line, 100.0)) << line;
}

// Ten seconds of four processors' time: two and a half on the clock.
TEST(ProcessorUse, CountsProcessors) {
    const ProcessorTimes before{
        .own_s = 1.0, .busy_s = 10.0, .idle_s = 100.0, .stolen_s = 5.0, .processors = 4};
    const ProcessorTimes after{
        .own_s = 4.0, .busy_s = 14.0, .idle_s = 103.0, .stolen_s = 8.0, .processors = 4};
    const auto use = use_between(before, after);
    ASSERT_TRUE(use);
    EXPECT_EQ(use->processors, 4);
    EXPECT_DOUBLE_EQ(use->own, 1.2);
    EXPECT_DOUBLE_EQ(use->others, 0.4);
    EXPECT_DOUBLE_EQ(use->stolen, 1.2);
    EXPECT_DOUBLE_EQ(use->elsewhere(), 1.6);
    EXPECT_FALSE(use_between(before, before));
}

// Against getrusage, another book of the same kernel.
TEST(ProcessorUse, CountsAllThreadsOfTheProcess) {
    const auto booked = [] {
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        const auto of = [](const timeval& t) {
            return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
        };
        return of(usage.ru_utime) + of(usage.ru_stime);
    };
    const auto spin = [] {
        const std::clock_t until = std::clock() + CLOCKS_PER_SEC / 20;
        while (std::clock() < until) {
        }
    };
    const auto before = process_time();
    const double booked_before = booked();
    std::thread other(spin);
    spin();
    other.join();
    const double passed_s = std::chrono::duration<double>(process_time() - before).count();
    EXPECT_GE(passed_s, 0.05);
    EXPECT_NEAR(passed_s, booked() - booked_before, 0.02);
}

}  // namespace
}  // namespace foverig
