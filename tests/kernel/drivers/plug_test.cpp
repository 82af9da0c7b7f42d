// Unplugging and plugging in while a source reads: the pose goes stale, the source comes back.
#include <signal.h>

#include <fstream>
#include <functional>

#include "devices/dk2/imu_source.h"
#include "devices/fusion/head_fusion.h"
#include "devices/gaze/gaze_source.h"
#include "tests/kernel/drivers/desk.h"
#include "tests/kernel/exposed.h"

namespace foverig::test {
namespace {

constexpr Nanoseconds kStaleAfter{150'000'000};

/// Reads until `done`; false where that does not come.
template <class Source, class OnSample, class Done_>
bool read_until(Source& source, const Clock& clock, OnSample on_sample, Done_ done) {
    const HostTime end = clock.now() + 600 * kSecond;
    while (!done() && clock.now() < end) {
        const auto next = source.next(clock.now() + kSecond / 20);
        if (const auto* sample = std::get_if<typename Source::Sample>(&next)) {
            on_sample(*sample);
        } else if (std::holds_alternative<Fault>(next)) {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));  // a fault does not wait
        }
    }
    return done();
}

/// `again`: makes the headset come back, where it does not by itself.
void expect_pose_goes_stale_and_comes_back(const std::function<void()>& unplug,
                                           const std::function<void()>& again) {
    WallClock clock;
    const auto link = headset(clock);
    ASSERT_TRUE(link);
    auto source = dk2::Dk2ImuSource::open(*link, clock.now());
    ASSERT_TRUE(source) << source.error().text;
    auto reading = std::move(source).value();
    HeadFusion fusion;
    const auto add = [&](const ImuSample& sample) { fusion.add(sample); };
    const auto stale = [&] {
        return fusion.started() &&
               (fusion.at(clock.now()).stale || clock.now() - fusion.newest_sample() > kStaleAfter);
    };
    const auto seconds_seen = [&](std::uint64_t n) {
        return [&reading, n] { return reading.counts().samples >= 1000 * n; };
    };

    ASSERT_TRUE(read_until(reading, clock, add, seconds_seen(1)));
    // The thousand may have waited while the headset was set up.
    ASSERT_TRUE(read_until(reading, clock, add, [&] { return !stale(); }));
    unplug();
    ASSERT_TRUE(read_until(reading, clock, add, stale)) << "unplugged, and the pose is fresh";
    again();
    const auto before = reading.counts().samples;
    ASSERT_TRUE(read_until(reading, clock, add, [&] {
        return reading.counts().samples > before + 1000;
    })) << "it did not come back";
    ASSERT_TRUE(read_until(reading, clock, add, [&] { return !stale(); }));
    EXPECT_LE(reading.counts().reconnects, 2u);
    EXPECT_GE(reading.counts().reconnects, 1u) << "a node that is half there may be opened twice";
    // Its clock began anew, which the decoder believes after 16 reports.
    EXPECT_LT(reading.counts().rejected, 16u);
}

TEST(Plug, AHeadsetThatIsPulledComesBackByItself) {
    Exposed process({"dk2", "--set", "motion.head=look", "--set", "faults.dk2.unplug_at=25",
                     "--set", "faults.dk2.unplug_for=2"});
    expect_pose_goes_stale_and_comes_back([] {}, [] {});
    EXPECT_EQ(process.stop(), 0);
    EXPECT_NE(process.said().find("plugged in 2 times"), std::string::npos) << process.said();
}

TEST(Plug, AHeadsetThatDiesIsFoundAgainByItsSerial) {
    std::optional<Exposed> process(std::in_place, std::vector<std::string>{"dk2"});
    expect_pose_goes_stale_and_comes_back(
        [&] { EXPECT_EQ(process->stop(SIGKILL), -SIGKILL); },
        [&] { process.emplace(std::vector<std::string>{"dk2"}); });
}

TEST(Plug, ATrackerThatIsPulledIsStartedAgain) {
    Exposed process(
        {"gaze", "--set", "faults.gaze.unplug_at=22", "--set", "faults.gaze.unplug_for=2"});
    WallClock clock;
    const auto link = tracker(clock);
    ASSERT_TRUE(link);
    auto source = gaze::GazeSource::open(*link, clock, {.rate_hz = 250});
    ASSERT_TRUE(source) << source.error().text;
    auto reading = std::move(source).value();
    const auto ignore = [](const GazeSample&) {};
    ASSERT_TRUE(read_until(reading, clock, ignore, [&] { return reading.counts().samples > 250; }));
    ASSERT_TRUE(
        read_until(reading, clock, ignore, [&] { return reading.counts().reconnects > 0; }));
    const auto before = reading.counts().samples;
    ASSERT_TRUE(read_until(reading, clock, ignore,
                           [&] { return reading.counts().samples > before + 250; }));
    EXPECT_EQ(reading.counts().rejected, 0u);
    EXPECT_EQ(process.stop(), 0);
}

TEST(Plug, TheProgramRecordsFromExposedDevices) {
    Exposed headset_process(std::vector<std::string>{"dk2"});
    Exposed tracker_process(std::vector<std::string>{"gaze"});
    {
        WallClock clock;  // both nodes are there
        ASSERT_TRUE(headset(clock) && tracker(clock));
    }
    const std::string file = fresh_file("desk.mcap"), text = fresh_file("said.txt");
    const std::string command = std::string(FOVERIG_PROGRAM) +
                                " record --devices hardware --clock wall --seconds 3 --out " +
                                file + " >" + text + " 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0);
    std::ifstream in(text);
    const std::string said{std::istreambuf_iterator<char>(in), {}};
    std::size_t clean = 0;
    for (std::size_t at = 0;
         (at = said.find(" 0 lost, 0 rejected, 0 reconnects", at)) != std::string::npos; ++at) {
        ++clean;
    }
    EXPECT_EQ(clean, 2u) << said;
}

}  // namespace
}  // namespace foverig::test
