#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "simulators/motion/blinks.h"
#include "simulators/motion/look_head.h"
#include "simulators/motion/recorded_eye.h"
#include "simulators/motion/recorded_head.h"
#include "simulators/motion/scan_eye.h"

namespace foverig::motion {
namespace {

namespace fs = std::filesystem;

fs::path recording(const std::string& name) {
    return fs::path(FOVERIG_SOURCE_DIR) / "tests/recordings" / name;
}

/// A file with this text, removed again.
class TextFile {
  public:
    explicit TextFile(const std::string& text)
        : path_(fs::path(testing::TempDir()) /
                ("trajectory_" +
                 std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + "_" +
                 std::to_string(getpid()) + "_" + std::to_string(count_++) + ".csv")) {
        std::ofstream(path_) << text;
    }
    ~TextFile() { fs::remove(path_); }
    TextFile(const TextFile&) = delete;
    TextFile& operator=(const TextFile&) = delete;
    const fs::path& path() const { return path_; }

  private:
    static inline int count_ = 0;
    fs::path path_;
};

double angle_deg(const dquat& a, const dquat& b) {
    const dquat d = glm::conjugate(a) * b;
    return glm::degrees(2.0 *
                        std::atan2(std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z), std::abs(d.w)));
}

TEST(RecordedHead, PlaysTheModelItWasMadeOf) {
    const auto played = RecordedHead::load(recording("head_look_10s.csv"));
    ASSERT_TRUE(played) << played.error().text;
    const LookHead look(1);
    for (double t = 0.0; t < 10.0; t += 0.0013) {
        const HeadState a = played->at(t), b = look.at(t);
        ASSERT_LT(angle_deg(a.world_from_head, b.world_from_head), 2e-3) << t;
        ASSERT_LT(glm::distance(a.position_m, b.position_m), 2e-5) << t;
        ASSERT_LT(glm::distance(a.angular_velocity_rad_s, b.angular_velocity_rad_s), 0.04) << t;
    }
}

TEST(RecordedHead, IntegratesToItsOwnRows) {
    const auto played = RecordedHead::load(recording("head_look_10s.csv"));
    ASSERT_TRUE(played);
    dquat q = played->at(0.0).world_from_head;
    for (int i = 0; i < 10000; ++i) {
        const dvec3 turn = 1e-3 * played->at(1e-3 * (i + 0.5)).angular_velocity_rad_s;
        const double angle = glm::length(turn);
        q = glm::normalize(q * glm::angleAxis(angle, turn / angle));
    }
    EXPECT_LT(angle_deg(q, played->at(10.0).world_from_head), 1e-5);
}

TEST(RecordedHead, TurnsAtConstantSpeedBetweenTwoRows) {
    const double half = glm::radians(45.0);
    const RecordedHead head(
        {{0.0, dquat(1, 0, 0, 0), {}}, {1.0, dquat(std::cos(half), 0, std::sin(half), 0), {}}},
        false);
    EXPECT_NEAR(glm::degrees(head.at(0.25).angular_velocity_rad_s.y), 90.0, 1e-9);
    EXPECT_NEAR(angle_deg(head.at(0.25).world_from_head, dquat(1, 0, 0, 0)), 22.5, 1e-9);
    // Before and after, the head rests.
    EXPECT_EQ(head.at(-1.0).angular_velocity_rad_s, dvec3(0.0));
    EXPECT_NEAR(angle_deg(head.at(9.0).world_from_head, dquat(1, 0, 0, 0)), 90.0, 1e-9);
}

TEST(RecordedHead, TakesTheShorterWayForQuaternionsOfOppositeSign) {
    const double half = glm::radians(5.0);
    const RecordedHead head(
        {{0.0, dquat(1, 0, 0, 0), {}}, {1.0, -dquat(std::cos(half), 0, std::sin(half), 0), {}}},
        false);
    EXPECT_NEAR(glm::degrees(glm::length(head.at(0.5).angular_velocity_rad_s)), 10.0, 1e-9);
}

TEST(RecordedEye, PlaysTheModelItWasMadeOf) {
    const auto played = RecordedEye::load(recording("gaze_scan_10s.csv"));
    ASSERT_TRUE(played) << played.error().text;
    const ScanEye scan(1);
    const BlinkingEye eye(scan, 1, 14.0);
    for (int i = 0; i <= 600; ++i) {
        const EyeState a = played->at(i / 60.0), b = eye.at(i / 60.0);
        EXPECT_LT(glm::degrees(glm::distance(a.direction, b.direction)), 1e-3);
        EXPECT_NEAR(a.openness, b.openness, 1e-3);
    }
}

TEST(Trajectory, SaysWhatIsWrongAndWhere) {
    const std::string header = "t_s,qw,qx,qy,qz\n";
    const struct {
        std::string text, expected;
    } cases[] = {
        {"", "0 rows"},
        {header + "0,1,0,0,0\n", "1 rows"},
        {header + "0,1,0,0,0\n1,1,0,0\n", ":3: 4 cells"},
        {header + "0,1,0,0,0\n1,1,0,zero,0\n", ":3: 'zero' in column qy"},
        {header + "0,1,0,0,0\n1,nan,0,0,0\n", "'nan' in column qw"},
        {header + "0,1,0,0,0\n\n# remark\n0,1,0,0,0\n", ":5: time 0 s"},
        {header + "0,1,0,0,0\n1,2,0,0,0\n", ":3: the quaternion's length is 2"},
        {"time,qw,qx,qy,qz\n0,1,0,0,0\n1,1,0,0,0\n", "expected 't_s,qw,qx,qy,qz'"},
    };
    for (const auto& c : cases) {
        const TextFile file(c.text);
        const auto loaded = RecordedHead::load(file.path());
        ASSERT_FALSE(loaded) << c.text;
        EXPECT_NE(loaded.error().text.find(c.expected), std::string::npos) << loaded.error().text;
        EXPECT_NE(loaded.error().text.find(file.path().string()), std::string::npos);
        EXPECT_EQ(std::count(loaded.error().text.begin(), loaded.error().text.end(), '\n'), 0);
    }
    EXPECT_EQ(RecordedHead::load("no/such.csv").error().code, ErrorCode::not_found);
    EXPECT_EQ(RecordedHead::load(testing::TempDir()).error().code, ErrorCode::not_found);
}

TEST(Trajectory, GazeOutOfSightIsRefused) {
    const TextFile file("t_s,gaze_x_deg,gaze_y_deg\n0,0,0\n1,100,0\n");
    const auto loaded = RecordedEye::load(file.path());
    ASSERT_FALSE(loaded);
    EXPECT_NE(loaded.error().text.find(":3:"), std::string::npos);
}

}  // namespace
}  // namespace foverig::motion
