// The report as a browser sees it: headless Chromium, where there is one.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "rig/report/markup.h"
#include "rig/report/run_data.h"
#include "rig/report/scripts.h"
#include "tests/rig/program_bench.h"

namespace foverig::report {
namespace {

namespace fs = std::filesystem;
using test::text_of;
using testing::HasSubstr;
using testing::Not;

class PageInBrowser : public test::ProgramBench {
  protected:
    void SetUp() override {
        ProgramBench::SetUp();
        if (std::system("chromium --version >/dev/null 2>&1") != 0) {
            GTEST_SKIP() << "no chromium here";
        }
        const fs::path page = make();
        if (HasFailure()) return;
        open(page);
        if (dom_.empty()) GTEST_SKIP() << "chromium opens nothing here: " << said_.substr(0, 300);
    }

    /// The page, made by the program.
    virtual fs::path make() const = 0;

    /// The document once its scripts have run, and what the console said.
    void open(const fs::path& page) {
        const std::string command =
            "HOME='" + root_.string() +
            "' timeout 400 chromium --headless --no-sandbox --disable-gpu --no-first-run "
            "--disable-background-networking --enable-logging=stderr --window-size=1200,900 "
            "--dump-dom 'file://" +
            fs::absolute(page).string() + "' >'" + (root_ / "dom").string() + "' 2>'" +
            (root_ / "said").string() + "' </dev/null";
        opened_ = std::system(command.c_str()) == 0;
        dom_ = text_of(root_ / "dom");
        said_ = text_of(root_ / "said");
    }

    void expect_quiet_page_that_refuses_to_fetch(const fs::path& page) {
        EXPECT_TRUE(opened_);
        EXPECT_THAT(said_, Not(HasSubstr("CONSOLE")));
        EXPECT_THAT(dom_, HasSubstr("</html>"));

        // The page's own policy makes of every request an error that would be seen here.
        std::string html = text_of(page);
        html.insert(html.find("<main>"), "<img src=\"https://example.org/a.png\">");
        std::ofstream(root_ / "fetching.html") << html;
        open(root_ / "fetching.html");
        EXPECT_THAT(said_, HasSubstr("CONSOLE"));
        EXPECT_THAT(said_, HasSubstr("Content Security Policy"));
    }

    bool opened_ = false;
    std::string dom_, said_;
};

class ReportInBrowser : public PageInBrowser {
  protected:
    fs::path make() const override {
        const auto run = small_run("run", {"--frames", "12"});
        EXPECT_EQ(run.code, 0) << run.err;
        return root_ / "run/report.html";
    }

    /// Of <div id="frame-strip" data-NAME="...">.
    double strip_value(const std::string& name) const {
        std::smatch found;
        const bool there = std::regex_search(
            dom_, found, std::regex("id=\"frame-strip\"[^>]*data-" + name + "=\"([^\"]*)\""));
        EXPECT_TRUE(there) << name;
        return there ? std::stod(found[1]) : -1.0;
    }
};

class SweepInBrowser : public PageInBrowser {
  protected:
    fs::path make() const override {
        const auto sweep = test::foverig({"sweep", FOVERIG_SOURCE_DIR "/sweeps/smoke.toml", "--out",
                                          (root_ / "sweep").string()});
        EXPECT_EQ(sweep.code, 0) << sweep.err;
        return root_ / "sweep/pareto.html";
    }
};

TEST_F(ReportInBrowser, HasNoErrorAndFetchesNothing) {
    expect_quiet_page_that_refuses_to_fetch(root_ / "run/report.html");
}

TEST_F(SweepInBrowser, HasNoErrorFetchesNothingAndShowsTheJsonsNumbers) {
    const auto pareto = nlohmann::json::parse(text_of(root_ / "sweep/pareto.json"));
    const std::string axis = pareto["error"];
    for (const auto& point : pareto["points"])
        EXPECT_THAT(dom_, HasSubstr(number(point["error"][axis]["mean"].get<double>())));
    EXPECT_THAT(dom_, HasSubstr("class=\"default-ring\""));
    expect_quiet_page_that_refuses_to_fetch(root_ / "sweep/pareto.html");
}

TEST_F(ReportInBrowser, ShowsTheSummarysNumbers) {
    const RunData run = read_run(root_ / "run");
    EXPECT_THAT(dom_, HasSubstr("<b>" + number(run.number({"frame_time_ms", "p50"}))));
    EXPECT_THAT(dom_, HasSubstr("<b>" + count(run.number({"frames", "rendered"}))));
    if (kStripScript.empty()) GTEST_SKIP() << "built without uPlot: the strip is static";
    EXPECT_EQ(strip_value("frames"), run.number({"frames", "rendered"}).value());
    EXPECT_NEAR(strip_value("most-ms"), run.number({"frame_time_ms", "max"}).value(), 5e-4);
    EXPECT_THAT(dom_, HasSubstr("<canvas"));
}

TEST_F(ReportInBrowser, PutsALensOverEveryPictureOfAnEye) {
    const auto times = [&](const std::string& what) {
        std::size_t n = 0;
        for (auto at = dom_.find(what); at != std::string::npos; at = dom_.find(what, at + 1)) ++n;
        return n;
    };
    EXPECT_GE(times("<div class=\"lens\">"), 4U);  // two eyes, rendered and difference
    EXPECT_EQ(times("<div class=\"lens\">"), times("<figure class=\"eye\">"));
}

}  // namespace
}  // namespace foverig::report
