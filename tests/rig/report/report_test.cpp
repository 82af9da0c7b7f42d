#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "renderer/image.h"
#include "rig/failure.h"
#include "rig/output/run_folder.h"
#include "rig/records/summary.h"
#include "rig/report/markup.h"
#include "rig/report/page.h"
#include "rig/report/picture.h"
#include "rig/report/svg.h"

namespace foverig::report {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

HostTime at_ms(double ms) {
    return HostTime(from_seconds(ms * 1e-3));
}

RunRecord some_run() {
    RunRecord run;
    for (int i = 0; i < 12; ++i) {
        FrameRecord f;
        const double t = 13.333 * i;
        f.frame = static_cast<std::uint32_t>(i);
        f.begin = at_ms(t);
        f.pose = {at_ms(t - 2.0), at_ms(t - 1.0)};
        f.submit = at_ms(t + 8.0);
        f.present = at_ms(t + 9.0);
        f.vsync = f.aimed_vsync = at_ms(t + 13.333);
        f.shown_vsync = static_cast<std::uint64_t>(i + 1);
        f.photon = at_ms(t + 20.0);
        f.passes = {{"trace_primary", 5.0}, {"shade", 2.0}};
        f.render_ms = 7.5;
        f.cpu_ms = 14.0;
        run.frames.push_back(f);
    }
    PlannedEffect effect;
    effect.name = "area_light";
    effect.on = true;
    effect.because = "2 lights <b>";
    run.plan = {effect};
    return run;
}

/// A licence may name its author's site; what is between script tags is not fetched (browser_test).
std::string without_scripts(std::string html) {
    for (auto from = html.find("<script"); from != std::string::npos;
         from = html.find("<script", from)) {
        html.erase(from, html.find("</script>", from) - from + 9);
    }
    return html;
}

class ReportTest : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) / ("report_test_" + std::to_string(getpid()));
        fs::create_directories(folder_ / "images");
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string page_of(const RunRecord& run, const nlohmann::json& images) {
        const nlohmann::json scenario = {
            {"scene", "a & <b>"}, {"clock", "lockstep"}, {"cost", "measured"}};
        auto summary = summary_json(run, scenario, BuildInfo{}, HostInfo{}, 1000);
        summary["images"] = images;
        write_text(folder_ / "summary.json", summary.dump());
        write_text(folder_ / "frames.csv", frames_csv(run.frames, WallTimes::keep));
        return page(read_run(folder_));
    }

    fs::path folder_;
};

TEST_F(ReportTest, AsksNobodyForAnything) {
    write_png(folder_ / "images/a.png", Image{8, 8, std::vector<vec3>(64, vec3(0.5F))});
    const std::string html = page_of(
        some_run(), {{{"frame", 3}, {"kind", "final"}, {"eye", "left"}, {"file", "images/a.png"}}});
    EXPECT_THAT(html, HasSubstr("src=\"data:image/jpeg;base64,"));
    EXPECT_THAT(without_scripts(html), Not(HasSubstr("http:")));
    EXPECT_THAT(without_scripts(html), Not(HasSubstr("https:")));
    EXPECT_THAT(html, Not(HasSubstr("<script src")));
    EXPECT_THAT(html, Not(HasSubstr("<link")));
    EXPECT_THAT(html, Not(HasSubstr("url(")));
    EXPECT_THAT(html, Not(HasSubstr("@import")));
    for (auto at = html.find("src="); at != std::string::npos; at = html.find("src=", at + 1)) {
        EXPECT_EQ(html.compare(at, 10, "src=\"data:"), 0);
    }
}

TEST_F(ReportTest, EscapesWhatOthersWrote) {
    const std::string html = page_of(some_run(), nlohmann::json::array());
    EXPECT_THAT(html, HasSubstr("a &amp; &lt;b&gt;"));
    EXPECT_THAT(html, HasSubstr("2 lights &lt;b&gt;"));
    EXPECT_THAT(html, Not(HasSubstr("a & <b>")));
}

TEST_F(ReportTest, TakesLatencyApartIntoLinksThatAddUp) {
    const std::string html = page_of(some_run(), nlohmann::json::array());
    EXPECT_THAT(html, HasSubstr("<b>motion to photon</b></td><td class=\"n\">22.0"));
    EXPECT_THAT(html, HasSubstr("render: 8.00 ms"));
    EXPECT_THAT(html, HasSubstr("distort: 1.00 ms"));
    EXPECT_THAT(html, HasSubstr("wait: 4.33 ms"));
    EXPECT_THAT(html, Not(HasSubstr("<b>gaze to photon</b>")));  // no gaze was measured
}

TEST_F(ReportTest, NamesTheWorstFrameAndThePassThatMadeItSo) {
    RunRecord run = some_run();
    run.frames[5].submit = at_ms(13.333 * 5 + 30.0);
    run.frames[5].present = at_ms(13.333 * 5 + 31.0);
    run.frames[5].passes = {{"trace_primary", 5.5}, {"shade", 23.0}};
    run.frames[5].cpu_ms = 14.5;
    const std::string html = page_of(run, nlohmann::json::array());
    EXPECT_THAT(html, HasSubstr("<td class=\"n\">5</td><td class=\"n\">31.0</td>"
                                "<td class=\"n\">+22.0</td><td class=\"n\">+0.5</td>"));
    EXPECT_THAT(html, HasSubstr("<code>shade</code> +21.0 ms"));
    EXPECT_THAT(html, HasSubstr("foverig run scenario.toml --out again"));
}

TEST_F(ReportTest, SaysWhetherTheRateHolds) {
    EXPECT_THAT(page_of(some_run(), nlohmann::json::array()), HasSubstr("Holds 75 Hz"));
    RunRecord slow = some_run();
    for (std::size_t i = 0; i < slow.frames.size(); ++i) slow.frames[i].shown_vsync = 3 * i;
    EXPECT_THAT(page_of(slow, nlohmann::json::array()), HasSubstr("Does not hold 75 Hz"));
    RunRecord wrong = some_run();
    wrong.frames[0].numerics.nan = 1;
    EXPECT_THAT(page_of(wrong, nlohmann::json::array()), HasSubstr("Not valid"));
}

TEST_F(ReportTest, SaysThatTheMachineHadOtherWork) {
    RunRecord run = some_run();
    EXPECT_THAT(page_of(run, nlohmann::json::array()), Not(HasSubstr("went elsewhere")));
    run.processor_use = ProcessorUse{.processors = 4, .own = 0.4, .others = 0.7, .stolen = 0.3};
    for (std::size_t i = 0; i < run.frames.size(); ++i) run.frames[i].shown_vsync = 3 * i;
    EXPECT_THAT(page_of(run, nlohmann::json::array()),
                HasSubstr("1.0 of 4 processors: 0.3 to other guests of its host, 0.7 to other "));
}

TEST_F(ReportTest, StandsARunWithoutFrames) {
    RunRecord empty;
    EXPECT_THAT(page_of(empty, nlohmann::json::array()), HasSubstr("No frame was shown"));
}

TEST_F(ReportTest, StaysSmallHoweverManyImages) {
    std::vector<vec3> noise;
    std::uint32_t state = 1;
    for (int i = 0; i < 800 * 800; ++i) {
        state = state * 1664525U + 1013904223U;
        noise.emplace_back(static_cast<float>(state >> 8U) / 16777216.0F);
    }
    write_png(folder_ / "images/noise.png", Image{800, 800, noise});
    nlohmann::json images = nlohmann::json::array();
    for (int i = 0; i < 24; ++i) {
        images.push_back(
            {{"frame", i}, {"kind", "final"}, {"eye", "left"}, {"file", "images/noise.png"}});
    }
    EXPECT_LT(page_of(some_run(), images).size(), 6'000'000U);
}

TEST_F(ReportTest, RefusesAFolderThatIsNoRun) {
    EXPECT_THROW(read_run(folder_), InputError);
    write_text(folder_ / "summary.json", "{\"schema\": \"something else\"}");
    EXPECT_THROW(read_run(folder_), InputError);
    write_text(folder_ / "summary.json", "{ broken");
    EXPECT_THROW(read_run(folder_), InputError);
}

TEST(ReportNumbers, HaveThreeDigits) {
    EXPECT_EQ(number(0.0), "0");
    EXPECT_EQ(number(0.01234), "0.0123");
    EXPECT_EQ(number(1.0), "1.00");
    EXPECT_EQ(number(13.333), "13.3");
    EXPECT_EQ(number(99.96), "100");
    EXPECT_EQ(number(1234.5), "1234");
    EXPECT_EQ(number(std::nullopt), "–");
    EXPECT_EQ(count(3.0), "3");
    EXPECT_EQ(count(1'234'567.0), "1.23\u202fM");
    EXPECT_EQ(bytes(2048.0), "2.05\u202fkB");
}

TEST(ReportTicks, AreRoundNumbers) {
    EXPECT_EQ(ticks(10.0, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
    EXPECT_EQ(ticks(130.0, 5), (std::vector<double>{0, 50, 100}));
    EXPECT_EQ(ticks(0.0, 5), (std::vector<double>{0}));
}

// Half of the light of white is 188 of 255 in sRGB (IEC 61966-2-1), not 128.
TEST(Picture, ShrinksInLinearLight) {
    Picture checker{2, 2, {255, 255, 255, 0, 0, 0, 0, 0, 0, 255, 255, 255}};
    const Picture one = shrunk(checker, 1);
    ASSERT_EQ(one.rgb.size(), 3U);
    EXPECT_EQ(one.rgb[0], 188);
}

TEST(Picture, IsCroppedAroundAPlaceAndInside) {
    Picture row{4, 1, {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3}};
    EXPECT_EQ(cropped(row, 2.0, 0.5, 2).rgb, (std::vector<std::uint8_t>{1, 1, 1, 2, 2, 2}));
    Picture square{3, 3, std::vector<std::uint8_t>(27, 7)};
    square.rgb[26] = 9;
    EXPECT_EQ(cropped(square, 99.0, 99.0, 2).rgb.back(), 9);
    EXPECT_EQ(cropped(square, -5.0, -5.0, 2).rgb.size(), 12U);
}

TEST(Picture, NeverGrows) {
    const Picture small{1, 1, {1, 2, 3}};
    EXPECT_EQ(shrunk(small, 100).rgb, small.rgb);
}

}  // namespace
}  // namespace foverig::report
