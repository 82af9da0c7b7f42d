// `foverig calibrate` as its users meet it, without a display.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/rig/program_bench.h"

namespace foverig {
namespace {

using nlohmann::json;
using test::foverig;
using test::Outcome;
using test::text_of;
using testing::HasSubstr;

class ProgramCalibrateTest : public test::ProgramBench {
  protected:
    Outcome calibrate(int points, std::vector<std::string> more = {}) const {
        std::vector<std::string> arguments{"calibrate", "--points", std::to_string(points), "--out",
                                           file()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return foverig(arguments);
    }
    std::string file() const { return (root_ / "calibration.json").string(); }
    json result() const { return json::parse(text_of(file())); }
    double accuracy_deg(const char* eye) const {
        return result()["validation"]["mean"][eye]["accuracy_deg"].get<double>();
    }
};

const std::vector<std::string> kPerson{"--set", "faults.gaze.user=1", "--validate"};

TEST_F(ProgramCalibrateTest, MorePointsAreBetterAndTheFileSaysSo) {
    double former_deg = 3.0;  // uncalibrated: kappa alone is 5 degrees
    for (const int points : {0, 1, 5, 13}) {
        const Outcome run = calibrate(points, kPerson);
        ASSERT_EQ(run.code, 0) << run.err;
        EXPECT_THAT(run.out, HasSubstr("RMS-S2S (deg)"));
        const json file = result();
        EXPECT_EQ(file["calibration"]["points"], points);
        EXPECT_EQ(file["validation"]["targets"].size(), 9U);
        EXPECT_EQ(file["tracker"]["serial"], "FOVERIGSIM000001");
        if (points == 0) {
            EXPECT_GT(accuracy_deg("left"), former_deg);
            continue;
        }
        EXPECT_LT(accuracy_deg("left"), former_deg) << points;
        former_deg = accuracy_deg("left");
        // The tracker and the host judge the same samples.
        const json& target = file["validation"]["targets"][4];
        EXPECT_NEAR(target["left"]["accuracy_deg"].get<double>(),
                    target["tracker_says"]["accuracy_deg"]["left"].get<double>(), 0.01);
        EXPECT_NEAR(target["left"]["rms_s2s_deg"].get<double>(),
                    target["tracker_says"]["rms_s2s_deg"]["left"].get<double>(), 0.01);
    }
    EXPECT_LT(former_deg, 0.2);
}

TEST_F(ProgramCalibrateTest, PeopleBlinkAndAreAskedAgain) {
    const Outcome run =
        calibrate(9, {"--set", "faults.gaze.user=1", "--set", "faults.gaze.noise=0.12", "--set",
                      "faults.gaze.blink=40", "--set", "tracking.gaze_rate_hz=250"});
    ASSERT_EQ(run.code, 0) << run.err;
    int attempts = 0;
    const json file = result();
    for (const json& target : file["calibration"]["targets"])
        attempts += target["attempts"].get<int>();
    EXPECT_GT(attempts, 9) << "40 blinks a minute";
}

TEST_F(ProgramCalibrateTest, ARunTakesTheFile) {
    ASSERT_EQ(calibrate(9, kPerson).code, 0);
    const auto gaze_error_deg = [&](const char* name, std::vector<std::string> more) {
        more.insert(more.end(), {"--set", "faults.gaze.user=1", "--set", "motion.gaze=still"});
        const Outcome run = small_run(name, more);
        EXPECT_EQ(run.code, 0) << run.err;
        return json::parse(
                   text_of(root_ / name / "summary.json"))["latency_ms"]["gaze_error_deg"]["p50"]
            .get<double>();
    };
    EXPECT_GT(gaze_error_deg("before", {}), 3.0);
    EXPECT_LT(gaze_error_deg("after", {"--set", "tracking.gaze_calibration=" + file(), "--set",
                                       "recording.enabled=true"}),
              0.5);
    EXPECT_THAT(text_of(root_ / "after/session.mcap"), HasSubstr("tracker_data_hex"))
        << "the recording has it as an attachment";
    const Outcome again = foverig(
        {"replay", (root_ / "after/session.mcap").string(), "--out", (root_ / "again").string()});
    EXPECT_EQ(again.code, 0) << again.err;
    const auto samples = [&](const char* name) {
        return json::parse(text_of(root_ / name / "summary.json"))["devices"]["gaze"]["samples"]
            .get<int>();
    };
    EXPECT_EQ(samples("again"), samples("after"));
}

TEST_F(ProgramCalibrateTest, RefusesNumbersOfPointsThatTheProtocolLacks) {
    for (const int points : {2, 7, -1, 14}) {
        const Outcome run = calibrate(points);
        EXPECT_EQ(run.code, 2) << points;
        EXPECT_THAT(run.err, HasSubstr("expected 0, 1, 3, 5, 9 or 13"));
    }
    EXPECT_FALSE(std::filesystem::exists(file()));
}

TEST_F(ProgramCalibrateTest, NoiseIsRefusedAndNothingWritten) {
    const Outcome run = calibrate(5, {"--set", "faults.gaze.noise=3"});
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.err, HasSubstr("was refused 5 times: the gaze was not steady"));
    EXPECT_FALSE(std::filesystem::exists(file()));
}

TEST_F(ProgramCalibrateTest, UnpluggedInTheMiddleIsOneSentence) {
    const Outcome run =
        calibrate(9, {"--set", "faults.gaze.unplug_at=4", "--set", "faults.gaze.unplug_for=1"});
    EXPECT_EQ(run.code, 4);
    EXPECT_THAT(run.err, HasSubstr("at target 4 of 9: nothing was calibrated; plug it in"));
    EXPECT_FALSE(std::filesystem::exists(file()));
}

TEST_F(ProgramCalibrateTest, SaysWhatIsWrongWithAFile) {
    const auto run_with = [&](const std::string& name) {
        return small_run("run", {"--set", "tracking.gaze_calibration=" + name});
    };
    const Outcome missing = run_with((root_ / "nowhere.json").string());
    EXPECT_EQ(missing.code, 3);
    EXPECT_THAT(missing.err, HasSubstr("nowhere.json: cannot be read"));
    std::ofstream(file()) << "{\"tracker\": {\"serial\": \"FOVERIGSIM000001\"}}";
    EXPECT_THAT(run_with(file()).err, HasSubstr("has no text tracker_data_hex"));

    ASSERT_EQ(calibrate(1).code, 0);
    json other = result();
    other["tracker"]["serial"] = "OTHER";
    std::ofstream(file()) << other.dump();
    const Outcome foreign = run_with(file());
    EXPECT_EQ(foreign.code, 4);
    EXPECT_THAT(foreign.err, HasSubstr("the calibration is of tracker OTHER, and this is"));
    other["tracker_data_hex"] = "00ff";
    std::ofstream(file()) << other.dump();
    EXPECT_EQ(run_with(file()).code, 3);
}

TEST_F(ProgramCalibrateTest, ARecordingCannotBeCalibrated) {
    EXPECT_EQ(calibrate(5, {"--devices", "replay:some.mcap"}).code, 2);
}

}  // namespace
}  // namespace foverig
