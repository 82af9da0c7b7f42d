#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "rig/failure.h"
#include "rig/sweep/flight.h"
#include "rig/sweep/header.h"
#include "rig/sweep/read.h"

namespace foverig::sweep {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const char* const kCases = R"toml(
[reference]
lighting.area_samples = 64
[[cases]]
name = "box"
scenario.scene = "cornell"
scenario.lighting.ao_samples = 3
[[cases]]
name = "hall"
scenario.scene = "hall.obj"
stand_in.scene = "atrium"
stand_in.scene_detail = 0.5
[[variants]]
name = "full"
scenario.pipeline = "full"
[[variants]]
name = "small"
scenario.foveation.configuration = "small"
)toml";

const char* const kPaper = R"toml(
[paper]
source = "Somebody 2016"
baseline = "full"
[[paper.stages]]
name = "all"
passes = []
[[paper.values]]
case = "box"
variant = "small"
ms = 3.5
ms_error = 0.5
stages_ms = [3.5]
read = "a plot"
)toml";

class ReadCases : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) / ("read_cases_test_" + std::to_string(getpid()));
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
    /// The text with a part of it exchanged.
    static std::string with(std::string text, const std::string& part, const std::string& other) {
        return text.replace(text.find(part), part.size(), other);
    }

    fs::path folder_;
};

TEST_F(ReadCases, TriesEveryVariantOnEveryCaseAgainstTheCasesOwnReference) {
    const Sweep sweep = read(kCases);
    ASSERT_EQ(sweep.points.size(), 4U);
    EXPECT_EQ(sweep.points[1].variant, "small");
    EXPECT_EQ(sweep.points[2].of_case, 1U);
    EXPECT_EQ(sweep.points[1].scenario.scene, "cornell");
    EXPECT_EQ(sweep.points[1].scenario.render.foveation.r0_deg, 5.0);
    EXPECT_EQ(sweep.points[2].scenario.render.pipeline, "full");
    EXPECT_EQ(sweep.reference_of(sweep.points[1]).lighting.ao_samples, 3);
    EXPECT_EQ(sweep.reference_of(sweep.points[3]).lighting.ao_samples, 0);
    EXPECT_EQ(sweep.reference_of(sweep.points[3]).lighting.area_samples, 64);
    EXPECT_EQ(sweep.reference_of(sweep.points[1]).pipeline, "full");
    EXPECT_THAT(text_of(sweep.points[1].settings),
                HasSubstr("scene = \"cornell\", foveation.configuration = \"small\""));
    EXPECT_TRUE(definition_json(sweep).at("default_point").is_null());
}

TEST_F(ReadCases, PutsTheStandInWhereTheFileIsNotThereAndSaysSo) {
    const Sweep without = read(kCases);
    EXPECT_EQ(without.points[3].scenario.scene, "atrium");
    EXPECT_EQ(without.points[3].scenario.scene_detail, 0.5);
    EXPECT_EQ(without.cases[0].note, "");
    EXPECT_EQ(without.cases[1].note,
              (folder_ / "hall.obj").string() + " is not there: atrium stands in");
    std::ofstream(folder_ / "hall.obj") << "v 0 0 0\n";
    const Sweep there = read(kCases);
    EXPECT_EQ(there.points[3].scenario.scene, (folder_ / "hall.obj").string());
    EXPECT_EQ(there.points[3].scenario.scene_detail, 1.0);
    EXPECT_EQ(there.cases[1].note, "");
}

TEST_F(ReadCases, TakesAPapersNumbers) {
    const Sweep sweep = read(std::string(kCases) + kPaper);
    EXPECT_EQ(sweep.paper.at("baseline"), "full");
    EXPECT_EQ(sweep.paper.at("values").at(0).at("ms_error"), 0.5);
    EXPECT_TRUE(sweep.paper.at("values").at(0).at("mrays").is_null());
}

TEST_F(ReadCases, SaysWhatIsWrongAndWhere) {
    const std::string cases = kCases;
    const std::string all = cases + kPaper;
    EXPECT_THAT(complaint("[knobs]\nfoveation.p_min = [0.2]\n" + cases),
                HasSubstr("my.toml:1: cases have variants and no knobs"));
    EXPECT_THAT(complaint("prices = true\n" + cases), HasSubstr("no prices"));
    EXPECT_THAT(complaint(cases.substr(0, cases.find("[[variants]]"))),
                HasSubstr("has cases and no variants"));
    EXPECT_THAT(complaint("[[variants]]\nname = \"a\"\n"), HasSubstr("expected [[cases]]"));
    EXPECT_THAT(complaint(with(cases, "\"hall\"", "\"box\"")),
                HasSubstr("another one has the name box"));
    EXPECT_THAT(complaint(with(cases, "name = \"box\"", "")), HasSubstr("has no name"));
    EXPECT_THAT(complaint(with(cases, "stand_in.scene = \"atrium\"", "")),
                HasSubstr("stand_in names no scene"));
    EXPECT_THAT(complaint(with(cases, "ao_samples = 3", "oa_samples = 3")),
                HasSubstr("nearest known key is lighting.ao_samples"));
    EXPECT_THAT(complaint(with(all, "variant = \"small\"", "variant = \"smal\"")),
                HasSubstr("variant is \"smal\"; expected a name of this sweep's, the nearest is "
                          "small"));
    EXPECT_THAT(complaint(with(all, "[3.5]", "[3.5, 1.0]")), HasSubstr("stages_ms has 2 numbers"));
    EXPECT_THAT(complaint(with(all, "read = \"a plot\"", "")), HasSubstr("expected read = "));
    EXPECT_THAT(complaint(with(all, "ms = 3.5", "ms = -3.5")), HasSubstr("of at least 0"));
    EXPECT_THAT(complaint("stretches = 3\nstretch_frames = 40\n" + cases),
                HasSubstr("3 stretches of 40 frames"));
    EXPECT_THAT(complaint("stretches = 3\nstretch_frames = 2\n" + cases),
                HasSubstr("beyond the warm-up of 3"));
}

TEST(Stretches, AreSpreadOverTheFlight) {
    std::vector<FlownFrame> flight(100);
    for (std::uint32_t i = 0; i < 100; ++i) flight[i].input.frame = i;
    std::vector<std::uint32_t> numbers;
    for (const FlownFrame& frame : stretches_of(flight, {.count = 4, .frames = 3}))
        numbers.push_back(frame.input.frame);
    EXPECT_THAT(numbers, testing::ElementsAre(0, 1, 2, 25, 26, 27, 50, 51, 52, 75, 76, 77));
    EXPECT_EQ(stretches_of(flight, {}).size(), 100U);
}

}  // namespace
}  // namespace foverig::sweep
