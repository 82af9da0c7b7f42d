// How good must the gaze tracker be: `foverig sweep` with errors_at = "truth", on simulated eyes
// and on a recording, end to end.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/rig/program_bench.h"

namespace foverig {
namespace {

using test::foverig;
using test::Outcome;
using test::text_of;
using testing::HasSubstr;
namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Without sampled light, so that errors are foveation's alone, and r0 is what `fovea` judges: with
/// a smaller one noise spreads the samples over that. Gaze latencies and noises in turn: points 0
/// to 3 are (0, 0), (0, 4), (160, 0), (160, 4).
constexpr const char* kSweep = R"(
error = "fovea"
warm_up_frames = 4
over = ["tracking.gaze_added_latency_ms", "tracking.gaze_added_noise_deg"]
[scenario]
scene = "cornell"
scene_detail = 0.2
cost = "fixed:9"
foveation.configuration = "medium"
lighting.area_lights = false
lights.points_m = [0.0, 1.7, 0.3]
[scenario.display]
eyes = 1
eye_width_px = 118
eye_height_px = 146
distortion = false
[knobs]
tracking.gaze_added_latency_ms = [0.0, 160.0]
tracking.gaze_added_noise_deg = [0.0, 4.0]
)";

class ProgramTrackerSweep : public test::ProgramBench {
  protected:
    std::string place(const fs::path& name) const { return (root_ / name).string(); }

    /// `keys` go before the tables, `scenario` into [scenario].
    Outcome sweep(const std::string& name, const std::string& keys,
                  const std::string& scenario) const {
        std::string text = kSweep;
        text.insert(text.find("[scenario]\n") + 11, scenario + "\n");
        std::ofstream(root_ / (name + ".toml")) << keys << text;
        return foverig({"sweep", place(name + ".toml"), "--out", place(name)});
    }
    std::vector<double> fovea_errors(const fs::path& name) const {
        std::vector<double> errors;
        const Json pareto = Json::parse(text_of(root_ / name / "pareto.json"));
        for (const Json& point : pareto["points"])
            errors.push_back(point["error"]["fovea"]["mean"]);
        return errors;
    }
    void record(double seconds) const {
        const Outcome recorded = foverig({"record", "--seconds", std::to_string(seconds), "--out",
                                          place("eyes.mcap"), "--set", "scene=cornell"});
        ASSERT_EQ(recorded.code, 0) << recorded.err;
    }
};

TEST_F(ProgramTrackerSweep, FindsTheErrorWhereTheEyesLookAndNotWhereTheTrackerSays) {
    ASSERT_EQ(sweep("truth", "errors_at = \"truth\"\n", "frames = 100").code, 0);
    ASSERT_EQ(sweep("tracker", "errors_at = \"tracker\"\n", "frames = 100").code, 0);
    const auto truth = fovea_errors("truth");
    const auto tracker = fovea_errors("tracker");
    ASSERT_EQ(truth.size(), 4U);
    EXPECT_GT(truth[2], 2.0 * truth[0]) << "later";
    EXPECT_GT(truth[1], 1.1 * truth[0]) << "noisier";
    EXPECT_GT(truth[3], 2.0 * truth[0]) << "both";
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(tracker[i], 0.0) << "inside r0 it is the full image bit for bit: " << i;
    EXPECT_EQ(
        std::distance(fs::directory_iterator(root_ / "truth/reference"), fs::directory_iterator()),
        1)
        << "the reference needs no gaze";
    const std::string page = text_of(root_ / "truth/pareto.html");
    EXPECT_THAT(page, HasSubstr("where the eyes really looked"));
    EXPECT_THAT(page, HasSubstr("tracking.gaze_added_noise_deg"));
}

TEST_F(ProgramTrackerSweep, TakesTheRecordedTrackersWordForTheTruthOfAReplay) {
    record(2.5);
    const std::string devices = "devices = \"replay:" + place("eyes.mcap") + "\"\n";
    ASSERT_EQ(sweep("sim", "errors_at = \"truth\"\n", "frames = 100").code, 0);
    const Outcome outcome = sweep("replay", "errors_at = \"truth\"\n", devices + "frames = 100");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto sim = fovea_errors("sim");
    const auto replay = fovea_errors("replay");
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(replay[i], sim[i], 0.1 * sim[i])
            << "the same eyes, whose tracker was right: " << i;
}

TEST_F(ProgramTrackerSweep, RefusesARecordingThatEndsBeforeTheFlight) {
    record(0.6);
    const std::string devices = "devices = \"replay:" + place("eyes.mcap") + "\"\n";
    for (const char* keys : {"", "stretches = 2\nstretch_frames = 8\n"}) {
        const Outcome outcome = sweep("short", keys, devices + "frames = 100");
        EXPECT_EQ(outcome.code, 2) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr("scenario.frames = 100: the flight ends after "));
        fs::remove_all(root_ / "short");
    }
    EXPECT_EQ(sweep("looped", "", devices + "frames = 100\nreplay.loop = true").code, 0);
}

}  // namespace
}  // namespace foverig
