// `foverig diff` as its users meet it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "renderer/image_read.h"
#include "tests/rig/program_bench.h"

namespace foverig {
namespace {

using test::foverig;
using test::Outcome;
using testing::HasSubstr;
namespace fs = std::filesystem;
using Json = nlohmann::json;

class ProgramDiff : public test::ProgramBench {
  protected:
    std::string png(const char* name, float linear, int width_px = 40, int height_px = 30) const {
        const std::size_t count = static_cast<std::size_t>(width_px) * height_px;
        const fs::path file = root_ / name;
        fs::create_directories(file.parent_path());
        write_png(file, Image{width_px, height_px, std::vector<vec3>(count, vec3(linear))});
        return file.string();
    }

    static Json last_line(const Outcome& outcome) {
        const std::string text = outcome.out.substr(0, outcome.out.size() - 1);
        return Json::parse(text.substr(text.rfind('\n') + 1));
    }
};

TEST_F(ProgramDiff, SaysWhatBlackAndWhiteAreApart) {
    const Outcome diff =
        foverig({"diff", png("a.png", 0.0F), png("b.png", 1.0F), "--ppd", "20", "--json"});
    EXPECT_EQ(diff.code, 0) << diff.err;
    const Json json = last_line(diff);
    EXPECT_NEAR(json["flip"]["mean"].get<double>(), 0.96738, 1e-4);
    EXPECT_NEAR(json["mse"]["mean"].get<double>(), 65025.0, 1.0);
    EXPECT_NEAR(json["psnr"]["db"].get<double>(), 0.0, 1e-4);
    EXPECT_NEAR(json["gaze"]["absolute"]["acuity"].get<double>(), 1.0, 1e-5);
    EXPECT_EQ(json["pixels_per_degree"], 20.0);
    EXPECT_FALSE(json.contains("flicker"));
}

TEST_F(ProgramDiff, FindsNothingBetweenAFileAndItself) {
    const std::string file = png("a.png", 0.3F);
    const Json json = last_line(foverig({"diff", file, file, "--json"}));
    EXPECT_EQ(json["flip"]["max"], 0.0);
    EXPECT_EQ(json["mae"]["max"], 0.0);
    EXPECT_EQ(json["ssim"]["mean"], 1.0);
    EXPECT_TRUE(json["psnr"]["db"].is_null());
}

TEST_F(ProgramDiff, SaysOnlyWhatItIsAskedFor) {
    const std::string a = png("a.png", 0.3F), b = png("b.png", 0.4F);
    const Json json = last_line(foverig({"diff", a, b, "--metrics", "flip,mae", "--json"}));
    EXPECT_TRUE(json.contains("flip"));
    EXPECT_TRUE(json.contains("mae"));
    EXPECT_FALSE(json.contains("ssim"));
    const Outcome text = foverig({"diff", a, b, "--metrics", "ssim"});
    EXPECT_THAT(text.out, testing::StartsWith("ssim     mean 0.9"));
    EXPECT_EQ(foverig({"diff", a, b, "--metrics", "beauty"}).code, 2);
}

TEST_F(ProgramDiff, SaysInJodWhatPeopleWouldSee) {
    const std::string a = png("a.png", 0.3F), b = png("b.png", 0.31F);
    const Json same = last_line(foverig({"diff", a, a, "--metrics", "fvvdp", "--json"}));
    EXPECT_EQ(same["fvvdp"]["jod"], 10.0);
    EXPECT_EQ(same["fvvdp"]["foveated_jod"], 10.0);
    const Outcome screen =
        foverig({"diff", a, b, "--metrics", "fvvdp", "--peak-cd-m2", "1", "--black-cd-m2", "2"});
    EXPECT_EQ(screen.code, 2);
    EXPECT_THAT(screen.err, HasSubstr("expected a darker black"));
}

TEST_F(ProgramDiff, DrawsTheMap) {
    const fs::path map = root_ / "map.png";
    const std::string a = png("a.png", 0.0F), b = png("b.png", 1.0F);
    EXPECT_EQ(foverig({"diff", a, b, "--out", map.string()}).code, 0);
    const ReadImage read = read_image(map);
    EXPECT_EQ(read.image.width_px, 40);
    EXPECT_GT(read.image.at(20, 15).x, 0.9F);
    EXPECT_EQ(foverig({"diff", a, b, "--metrics", "mae", "--out", map.string()}).code, 2);
    const Outcome nowhere = foverig({"diff", a, b, "--out", (root_ / "none/map.png").string()});
    EXPECT_EQ(nowhere.code, 2);
    EXPECT_THAT(nowhere.err, HasSubstr("--out "));
}

TEST_F(ProgramDiff, RefusesWhatIsNoNumberAndWhatASinglePairHasNot) {
    const std::string a = png("a.png", 0.0F), b = png("b.png", 1.0F);
    for (const char* option :
         {"--ppd", "--fps", "--fovea-deg", "--peak-cd-m2", "--black-cd-m2", "--gaze"}) {
        const std::string value = option == std::string("--gaze") ? "nan,3" : "nan";
        EXPECT_EQ(foverig({"diff", a, b, option, value}).code, 2) << option;
    }
    for (const char* metric : {"change", "flip,flicker"}) {
        const Outcome outcome = foverig({"diff", a, b, "--metrics", metric});
        EXPECT_EQ(outcome.code, 2) << metric;
        EXPECT_THAT(outcome.err, HasSubstr("is of sequences"));
    }
}

TEST_F(ProgramDiff, ExitsWithThreeOnImagesThatCannotBeCompared) {
    const std::string a = png("a.png", 0.3F);
    const Outcome sizes = foverig({"diff", a, png("b.png", 0.3F, 41, 30)});
    EXPECT_EQ(sizes.code, 3);
    EXPECT_THAT(sizes.err, HasSubstr("40 x 30 pixels"));
    EXPECT_THAT(sizes.err, HasSubstr("expected one size"));
    const fs::path broken = root_ / "broken.png";
    std::ofstream(broken) << "\x89PNG and no more";
    const Outcome bad = foverig({"diff", a, broken.string()});
    EXPECT_EQ(bad.code, 3);
    EXPECT_THAT(bad.err, testing::MatchesRegex("foverig: [^\n]*broken.png: is a PNG that[^\n]+\n"));
    EXPECT_EQ(foverig({"diff", a, (root_ / "missing.png").string()}).code, 3);
    EXPECT_EQ(foverig({"diff", a, root_.string()}).code, 3);
}

TEST_F(ProgramDiff, CountsWhatIsNotANumberAndSaysSo) {
    const fs::path file = root_ / "nan.pfm";
    const std::vector<float> values{NAN, 1.0F, INFINITY};
    std::ofstream(file, std::ios::binary)
        << "PF\n1 1\n-1.0\n"
        << std::string_view(reinterpret_cast<const char*>(values.data()), 12);
    const Outcome diff = foverig({"diff", file.string(), file.string(), "--json"});
    EXPECT_EQ(diff.code, 0);
    EXPECT_THAT(diff.err, HasSubstr("2 values are NaN or infinite"));
    EXPECT_EQ(last_line(diff)["not_finite"]["test"], 2);
    EXPECT_EQ(last_line(diff)["flip"]["mean"], 0.0);
}

TEST_F(ProgramDiff, TakesTwoFoldersForASequence) {
    for (const char* name : {"0.png", "1.png", "2.png"}) {
        png((std::string("a/") + name).c_str(), 0.5F);
        png((std::string("b/") + name).c_str(), name[0] == '1' ? 0.6F : 0.5F);
    }
    const std::string a = (root_ / "a").string(), b = (root_ / "b").string();
    const Json json = last_line(foverig({"diff", a, b, "--json"}));
    EXPECT_EQ(json["frames"], 3);
    EXPECT_EQ(json["change"]["reference"], 0.0);
    EXPECT_NEAR(json["change"]["test"].get<double>(), 3.0 * json["mae"]["mean"].get<double>(),
                1e-9);
    EXPECT_GT(json["flicker"]["rms"].get<double>(), 0.0);
    EXPECT_NEAR(json["change"]["fovea"]["test"].get<double>(), json["change"]["test"].get<double>(),
                1e-4);
    EXPECT_FALSE(json["change"].contains("periphery"));
    EXPECT_LT(json["fvvdp"]["jod"].get<double>(), 10.0);
    EXPECT_EQ(foverig({"diff", a, b, "--out", (root_ / "m.png").string()}).code, 2);
    png("b/3.png", 0.5F);
    EXPECT_EQ(foverig({"diff", a, b}).code, 3);
}

}  // namespace
}  // namespace foverig
