#include "rig/sweep/read.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "rig/failure.h"

namespace foverig::sweep {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ReadSweep : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) / ("read_sweep_test_" + std::to_string(getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    Sweep read(const std::string& text) const {
        std::ofstream(folder_ / "my.toml") << text;
        return read_sweep(folder_ / "my.toml");
    }
    std::string complaint(const std::string& text) const {
        try {
            read(text);
        } catch (const UsageError& error) {
            return error.what();
        }
        return "";
    }

    fs::path folder_;
};

TEST_F(ReadSweep, TakesEveryCombinationAndMarksTheDefault) {
    const Sweep sweep = read(
        "[scenario]\nscene = \"cornell\"\n[knobs]\nlighting.area_samples = [1, 8]\n"
        "foveation.p_min = [0.05, 0.2]\n");
    EXPECT_EQ(sweep.name, "my");
    ASSERT_EQ(sweep.points.size(), 4U);
    EXPECT_EQ(text_of(sweep.points[sweep.default_point.value()].settings),
              "lighting.area_samples = 8, foveation.p_min = 0.05");
    EXPECT_EQ(sweep.points[1].scenario.render.foveation.p_min, 0.2);
    EXPECT_EQ(sweep.points[1].scenario.render.lighting.area_samples, 1);
    EXPECT_EQ(sweep.points[1].scenario.scene, "cornell");
    EXPECT_EQ(sweep.reference.pipeline, "full");
}

TEST_F(ReadSweep, AddsTheDefaultWhereTheDesignDoesNotMeetIt) {
    const Sweep sweep = read("[knobs]\nfoveation.p_min = [0.2, 0.3]\n");
    ASSERT_EQ(sweep.points.size(), 3U);
    EXPECT_EQ(sweep.default_point, 0U);
    EXPECT_EQ(text_of(sweep.points[0].settings), "foveation.p_min = 0.05");
}

TEST_F(ReadSweep, LetsAKnobWinOverTheConfigurationThatSetsIt) {
    const Sweep sweep = read(
        "[knobs]\nfoveation.p_min = [0.5]\nfoveation.configuration = [\"small\", \"large\"]\n");
    EXPECT_EQ(sweep.points[1].scenario.render.foveation.p_min, 0.5);
    EXPECT_EQ(sweep.points[1].scenario.render.foveation.r0_deg, 5.0);
    EXPECT_EQ(sweep.points[2].scenario.render.foveation.r0_deg, 15.0);
}

TEST_F(ReadSweep, DrawsALatinHypercube) {
    const Sweep sweep = read(
        "[knobs]\nfoveation.p_min = {from = 0.01, to = 1.0, log = true}\n"
        "lighting.area_samples = {from = 1, to = 16}\n[design]\nkind = \"latin\"\npoints = 12\n");
    EXPECT_EQ(sweep.points.size(), 13U) << "and the default";
}

TEST_F(ReadSweep, TakesABaseAndAReference) {
    std::ofstream(folder_ / "base.toml") << "scene = \"room.obj\"\nframes = 12\n";
    const Sweep sweep = read(
        "base = \"base.toml\"\nrepetitions = 5\norder = \"random\"\nwarm_up_frames = 2\n"
        "error = \"flip\"\nwithin = [0.1, 0.01]\n[knobs]\nfoveation.p_min = [0.2]\n"
        "[reference]\npipeline = \"reference\"\nreference.samples = 64\n");
    EXPECT_EQ(sweep.base.scene, (folder_ / "room.obj").string());
    EXPECT_EQ(sweep.base.frames, 12);
    EXPECT_EQ(sweep.repetitions, 5);
    EXPECT_EQ(sweep.order, Order::random);
    EXPECT_EQ(sweep.error, "flip");
    EXPECT_EQ(sweep.within.size(), 2U);
    EXPECT_EQ(sweep.reference.pipeline, "reference");
    EXPECT_EQ(sweep.reference.reference.samples, 64);
}

TEST_F(ReadSweep, SaysWhatIsWrongAndWhere) {
    const std::string knobs = "[knobs]\nfoveation.p_min = [0.2]\n";
    EXPECT_THAT(complaint("[scenario]\ndisplay.rate_hz = 5.0\n" + knobs),
                HasSubstr("display.rate_hz is 5; expected at least 8"));
    EXPECT_THAT(complaint("[knobs]\nfoveation.p_mim = [0.2]\n"),
                HasSubstr("my.toml:2: unknown knob foveation.p_mim; the nearest scenario key is "
                          "foveation.p_min"));
    EXPECT_THAT(complaint("[knobs]\nfoveation.p_min = []\n"),
                HasSubstr("my.toml:2: foveation.p_min has no values"));
    EXPECT_THAT(complaint("[knobs]\nfoveation.p_min = 0.2\n"), HasSubstr("has no values"));
    EXPECT_THAT(complaint("[knobs]\nfoveation.p_min = [1, 0.2, 1.0]\n"),
                HasSubstr("my.toml:2: foveation.p_min has the number 1 twice"));
    EXPECT_THAT(complaint("[knobs]\nfoveation.p_min = [0.2, \"x\"]\n"),
                HasSubstr("foveation.p_min is text \"x\"; expected a number from 0 to 1"));
    EXPECT_THAT(
        complaint("[knobs]\nfoveation.p_min = [7.0]\n"),
        HasSubstr("point foveation.p_min = 7.0: foveation.p_min is 7.0; expected a number"));
    EXPECT_THAT(complaint("[knobs]\nfoveation.r0_deg = [30.0]\n"),
                HasSubstr("expected r1_deg >= r0_deg"));
    EXPECT_THAT(complaint("[knobs]\nframes = [3]\n"), HasSubstr("frames is no knob"));
    EXPECT_THAT(complaint(""), HasSubstr("turns no knob"));
    EXPECT_THAT(complaint("[knobs]\n"), HasSubstr("turns no knob"));
    EXPECT_THAT(complaint("repetition = 3\n" + knobs),
                HasSubstr("my.toml:1: unknown key repetition; the nearest is repetitions"));
    EXPECT_THAT(complaint("repetitions = 0\n" + knobs),
                HasSubstr("expected a whole number from 1"));
    EXPECT_THAT(complaint("error = \"beauty\"\n" + knobs), HasSubstr("expected one of absolute"));
    EXPECT_THAT(complaint("within = 0.1\n" + knobs), HasSubstr("expected numbers"));
    EXPECT_THAT(complaint("[knobs\n"), HasSubstr("my.toml:1: not valid TOML"));
    EXPECT_THAT(complaint("[knobs]\nfoveation.p_min = {from = 0.1, to = 0.2}\n"),
                HasSubstr("is a range, which only design.kind = \"latin\" takes"));
    EXPECT_THAT(complaint("[knobs]\npipeline = {from = 0.1, to = 0.2}\n"),
                HasSubstr("for a number"));
    EXPECT_THAT(complaint("[design]\nkind = \"latin\"\n" + knobs), HasSubstr("needs points"));
    EXPECT_THAT(complaint(knobs + "[reference]\nframes = 3\n"),
                HasSubstr("keys of the renderer alone"));
    EXPECT_THAT(complaint(knobs + "[reference]\npipeline = \"reprojected\"\n"),
                HasSubstr("expected full or reference"));
    EXPECT_THAT(complaint("[scenario]\nframes = 3\n" + knobs), HasSubstr("beyond the warm-up"));
    EXPECT_THAT(complaint("[scenario]\nclock = \"wall\"\n" + knobs), HasSubstr("clock = lockstep"));
    EXPECT_THAT(complaint("[scenario]\nsceen = \"a\"\n" + knobs),
                HasSubstr("nearest known key is scene"));
    EXPECT_THAT(complaint("base = \"none.toml\"\n" + knobs),
                HasSubstr("none.toml: cannot be read"));
    EXPECT_THROW(read_sweep(folder_ / "missing.toml"), UsageError);
}

}  // namespace
}  // namespace foverig::sweep
