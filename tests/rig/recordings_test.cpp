// The recordings of tests/recordings through decoders, clock maps, fusion and filter: each against
// its line of golden.csv, and against the motion that its simulator was given, which knows nothing
// of any of these.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "rig/commands.h"
#include "rig/session/angles.h"
#include "rig/session/device_streams.h"
#include "rig/session/simulated_world.h"
#include "simulators/replay/replayed_device.h"

namespace foverig {
namespace {

/// What the devices of a recording came to. The order is that of golden.csv.
struct Report {
    SourceCounts imu, gaze;
    dquat head{1.0, 0.0, 0.0, 0.0};  ///< at the recording's end
    std::uint64_t gaze_seen = 0;     ///< samples with a valid left eye
    double mean_right_deg = 0.0, mean_up_deg = 0.0;
};

const std::string& folder() {
    static const std::string path = std::string(FOVERIG_SOURCE_DIR) + "/tests/recordings/";
    return path;
}

std::string counts_text(const SourceCounts& c) {
    return fmt::format("{},{},{},{}", c.samples, c.lost, c.rejected, c.reconnects);
}

std::string text_of(const Report& r) {
    return fmt::format("{},{},{:.6f},{:.6f},{:.6f},{:.6f},{},{:.3f},{:.3f}", counts_text(r.imu),
                       counts_text(r.gaze), r.head.w, r.head.x, r.head.y, r.head.z, r.gaze_seen,
                       r.mean_right_deg, r.mean_up_deg);
}

std::vector<double> numbers_of(const std::string& line) {
    std::vector<double> numbers;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) numbers.push_back(std::stod(cell));
    return numbers;
}

std::string golden_of(const std::string& name) {
    std::ifstream stream(folder() + "golden.csv");
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with(name + ",")) return line.substr(name.size() + 1);
    }
    return "";
}

/// Replays as fast as possible in the steps of a run's settling.
class Replayed {
  public:
    explicit Replayed(const std::string& name)
        : file_(folder() + name + ".mcap"),
          end_(Recording::open(file_).value().last()),
          scenario_(recorded_scenario(file_)),
          world_(make_world(scenario_, clock_)),
          streams_(scenario_, *world_, clock_, nullptr) {
        streams_.run_for(end_ - clock_.now());
    }

    HostTime end() const { return end_; }
    DeviceStreams& streams() { return streams_; }
    const Scenario& scenario() const { return scenario_; }

  private:
    std::string file_;
    HostTime end_;
    Scenario scenario_;
    ManualClock clock_;
    std::unique_ptr<World> world_;
    DeviceStreams streams_;
};

/// The gaze samples alone, from the same file.
std::vector<GazeSample> gaze_of(const std::string& name) {
    const Recording recording = Recording::open(folder() + name + ".mcap").value();
    ManualClock clock;
    ReplayedDevice device(recording, "gaze", clock, {.momentary_request = gaze::request::get_time});
    std::vector<GazeSample> samples;
    GazeTracker tracker(device, clock, [&](const GazeSample& s) { samples.push_back(s); });
    clock.sleep_until(recording.last());
    while (!device.at_end()) tracker.read_until(clock.now());  // a fault ends a reading
    return samples;
}

Report report_of(Replayed& replayed, const std::string& name) {
    Report r;
    r.imu = replayed.streams().head().record().counts;
    r.gaze = replayed.streams().gaze().record().counts;
    r.head = replayed.streams().head().predict(replayed.end()).world_from_head;
    for (const GazeSample& s : gaze_of(name)) {
        if (!s.left.ray.valid) continue;
        const dvec3& d = s.left.ray.direction;
        ++r.gaze_seen;
        r.mean_right_deg += degrees(std::atan2(d.x, -d.z));
        r.mean_up_deg += degrees(std::atan2(d.y, std::hypot(d.x, d.z)));
    }
    r.mean_right_deg /= static_cast<double>(std::max<std::uint64_t>(1, r.gaze_seen));
    r.mean_up_deg /= static_cast<double>(std::max<std::uint64_t>(1, r.gaze_seen));
    return r;
}

/// The motion behind a recording.
SimulatedWorld truth_of(Scenario scenario, Clock& clock) {
    scenario.devices = "sim";
    if (scenario.motion.head.ends_with(".csv")) scenario.motion.head = folder() + "fast-turns.csv";
    return SimulatedWorld(scenario, clock);
}

struct Case {
    const char* name;
    double head_error_deg;  ///< of the pose at the end, at most
    double gaze_error_deg;  ///< median of the left eye, at most
};

void PrintTo(const Case& c, std::ostream* out) {
    *out << c.name;
}

class Recordings : public testing::TestWithParam<Case> {};

// Tolerances: a perfect gyro in fusion stays within 0.1 degree; bias of 0.2 deg/s per axis for 2 s,
// or losses that gaps are integrated over, cost a few tenths; fast turns and unplug have tests of
// their own below. The gaze's clock map and the angles' quantisation cost 0.05 degree, noise of
// 0.12 degree its own size.
INSTANTIATE_TEST_SUITE_P(Files, Recordings,
                         testing::Values(Case{"still", 0.7, 0.05}, Case{"slow-look", 0.2, 0.3},
                                         Case{"fast-turns", 180.0, 0.2},
                                         Case{"timestamp-wrap", 0.2, 0.2}, Case{"losses", 1.0, 0.2},
                                         Case{"blink-rich-reading", 0.2, 0.3},
                                         Case{"unplug", 180.0, 0.2}),
                         [](const auto& param) {
                             std::string name = param.param.name;
                             std::erase(name, '-');
                             return name;
                         });

TEST_P(Recordings, ComeToTheirGoldenReport) {
    Replayed replayed(GetParam().name);
    const std::string got = text_of(report_of(replayed, GetParam().name));
    const auto expected = numbers_of(golden_of(GetParam().name));
    const auto numbers = numbers_of(got);
    ASSERT_EQ(numbers.size(), expected.size()) << GetParam().name << "," << got;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        // Counts exactly; angles to the arithmetic of another compiler.
        const bool is_count = i < 8 || i == 12;
        EXPECT_NEAR(numbers[i], expected[i], is_count ? 0.0 : 2e-3)
            << GetParam().name << "," << got;
    }
}

TEST_P(Recordings, AgreeWithTheMotionTheyWereMadeFrom) {
    const Case& c = GetParam();
    Replayed replayed(c.name);
    ManualClock clock;
    const SimulatedWorld truth = truth_of(replayed.scenario(), clock);
    const dquat head = replayed.streams().head().predict(replayed.end()).world_from_head;
    EXPECT_LE(angle_deg(head, *truth.true_head(replayed.end())), c.head_error_deg);
    std::vector<double> errors_deg;
    for (const GazeSample& s : gaze_of(c.name)) {
        if (!s.left.ray.valid) continue;
        errors_deg.push_back(angle_deg(s.left.ray.direction, (*truth.true_gaze(s.host_time))[0]));
    }
    ASSERT_GT(errors_deg.size(), 30U);
    const auto middle = errors_deg.begin() + static_cast<std::ptrdiff_t>(errors_deg.size() / 2);
    std::nth_element(errors_deg.begin(), middle, errors_deg.end());
    EXPECT_LE(*middle, c.gaze_error_deg);
}

/// Above 2000 deg/s the sensor clips: what the first turn loses is what its speed has above that.
TEST(FastTurns, LoseTheAngleAboveTheGyrosRange) {
    double lost_deg = 0.0;
    constexpr double kAngle_deg = 170.0, kTime_s = 0.14, kStep = 1e-5;
    for (double s = 0.0; s < 1.0; s += kStep) {
        const double speed_deg_s = kAngle_deg / kTime_s * 30.0 * s * s * (1.0 - s) * (1.0 - s);
        lost_deg += std::max(0.0, speed_deg_s - 2000.0) * kStep * kTime_s;
    }
    ASSERT_GT(lost_deg, 5.0);
    Replayed replayed("fast-turns");
    ManualClock clock;
    const SimulatedWorld truth = truth_of(replayed.scenario(), clock);
    const dquat head = replayed.streams().head().predict(replayed.end()).world_from_head;
    EXPECT_NEAR(angle_deg(head, *truth.true_head(replayed.end())), lost_deg, 1.0);
}

/// While the cable is out nothing is known of the head; gravity gives its tilt back afterwards.
TEST(Unplug, GravityGivesTheTiltBack) {
    Replayed replayed("unplug");
    ManualClock clock;
    const SimulatedWorld truth = truth_of(replayed.scenario(), clock);
    const dvec3 up(0.0, 1.0, 0.0);
    const dquat head = replayed.streams().head().predict(replayed.end()).world_from_head;
    const dquat true_head = *truth.true_head(replayed.end());
    EXPECT_LE(angle_deg(glm::conjugate(head) * up, glm::conjugate(true_head) * up), 2.0);
    EXPECT_EQ(replayed.streams().head().record().counts.reconnects, 1U);
}

}  // namespace
}  // namespace foverig
