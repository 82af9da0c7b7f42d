// The two sweeps that make a paper's table and figure again, and the section of the page.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rig/sweep/header.h"
#include "rig/sweep/page.h"
#include "rig/sweep/read.h"
#include "rig/sweep/result.h"

namespace foverig::sweep {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// Measured as if `full` took 100 ms and 2 M rays and every variant of it 40 ms and 0.5 M, the
/// machine slower from run to run.
Measured as_if_measured(const Sweep& sweep) {
    Measured measured;
    measured.definition = definition_json(sweep);
    measured.build = {{"version", "1"}, {"git", nullptr}};
    measured.hosts = {{{"cpu", "Abacus"}, {"cores", 2}}};
    for (std::size_t i = 0; i < sweep.points.size(); ++i) {
        const bool full = sweep.points[i].variant == "full";
        Accuracy accuracy;
        accuracy.point = i;
        for (const std::string& name : error_names())
            accuracy.errors[name] = std::vector<double>(24, full ? 0.0 : 0.01);
        accuracy.rays = {{"total", full ? 2.0e6 : 0.5e6}};
        measured.accuracies[i] = accuracy;
        for (int run = 0; run < 3; ++run) {
            const double ms = (full ? 100.0 : 40.0) * (1.0 + 0.1 * run);
            measured.times[i].push_back(
                {i, run, std::vector<double>(24, ms), {{"merge", 3.0}, {"trace_primary", 30.0}}});
        }
    }
    return measured;
}

json paper_of(const char* file) {
    return json(pareto_json(as_if_measured(read_sweep(file))).at("paper"));
}

const json& row_of(const json& paper, const std::string& of_case, const std::string& variant) {
    for (const json& row : paper.at("rows"))
        if (row.at("case") == of_case && row.at("variant") == variant) return row;
    throw std::runtime_error("no row " + of_case + ", " + variant);
}

// The text of section 4.1 quotes what its table's lost columns held.
TEST(PaperTable1, GivesTheSpeedUpsThatThePapersTextQuotes) {
    const json paper = paper_of(FOVERIG_SOURCE_DIR "/sweeps/table1.toml");
    double least = 1e9;
    double most = 0.0;
    double pixels = 0.0;
    int rows = 0;
    for (const json& row : paper.at("rows")) {
        if (row.at("variant") == "full") continue;
        const double speed_up = row.at("speed_up").at("theirs");
        least = std::min(least, speed_up);
        most = std::max(most, speed_up);
        pixels += 1.0 / row.at("ray_cut").at("theirs").get<double>();
        ++rows;
    }
    EXPECT_EQ(rows, 12);
    EXPECT_NEAR(least, 1.46, 0.005) << "Urban Sprawl, point light";
    EXPECT_NEAR(most, 4.18, 0.005) << "Sponza, occlusion";
    EXPECT_NEAR(1.0 - pixels / rows, 0.79, 0.005) << "fewer sampled pixels";
}

TEST(PaperTable1, SetsOursBesideThem) {
    const json paper = paper_of(FOVERIG_SOURCE_DIR "/sweeps/table1.toml");
    const json& row = row_of(paper, "Sponza, point light", "medium");
    EXPECT_NEAR(row.at("speed_up").at("ours").get<double>(), 2.5, 1e-12);
    EXPECT_NEAR(row.at("speed_up").at("ci95").at(0).get<double>(), 2.5, 1e-9)
        << "the drift is in both runs of a pair";
    EXPECT_NEAR(row.at("ray_cut").at("ours").get<double>(), 4.0, 1e-12);
    EXPECT_NEAR(row.at("ours").at("stages_ms").at(1).get<double>(), 30.0, 1e-12)
        << "what no other stage has is ray tracing";
    EXPECT_NEAR(row.at("ours").at("stages_ms").at(3).get<double>(), 3.0, 1e-12) << "merge";
    EXPECT_EQ(row.at("theirs").at("ms"), 7.26);
}

TEST(PaperFigure5, HasWhatThePaperPrintsOfItAndNothingElse) {
    const json paper = paper_of(FOVERIG_SOURCE_DIR "/sweeps/figure5.toml");
    EXPECT_EQ(paper.at("rows").size(), 12U) << "three lights, four settings";
    for (const char* variant : {"small", "large"})
        EXPECT_TRUE(row_of(paper, "Sponza, point light", variant).at("theirs").is_null());
    const json& row = row_of(paper, "Sponza, occlusion, 16 samples", "medium");
    EXPECT_NEAR(row.at("speed_up").at("theirs").get<double>(), 4.18, 0.005);
}

TEST(PaperPage, SetsTheNumbersSideBySideAndSaysWhatCannotBeCompared) {
    const auto pareto =
        pareto_json(as_if_measured(read_sweep(FOVERIG_SOURCE_DIR "/sweeps/figure5.toml")));
    const std::string html = page(pareto);
    EXPECT_THAT(html, HasSubstr("Beside the paper"));
    EXPECT_THAT(html, HasSubstr("The numbers themselves, not to be compared"));
    EXPECT_THAT(html, HasSubstr("speed_up 4.18 in the paper"));
    EXPECT_THAT(html, HasSubstr("speed_up 2.5 here"));
    EXPECT_THAT(html, HasSubstr("not given"));
    EXPECT_THAT(html, HasSubstr("Error against time: Sponza, point light"));
    EXPECT_THAT(html, testing::Not(HasSubstr("<script")));
    EXPECT_THAT(html, testing::Not(HasSubstr("What one more millisecond buys")))
        << "settings of two scenes are no choice between each other";
}

TEST(CasesResult, HasAFrontOfEachCase) {
    const auto pareto =
        pareto_json(as_if_measured(read_sweep(FOVERIG_SOURCE_DIR "/sweeps/figure5.toml")));
    EXPECT_TRUE(pareto.at("front").empty());
    ASSERT_EQ(pareto.at("cases").size(), 3U);
    const auto& front = pareto.at("cases").at(1).at("front");
    ASSERT_EQ(front.size(), 2U) << "small is first of three alike, full errs less";
    EXPECT_EQ(front.at(0).at("point"), 5);
    EXPECT_EQ(front.at(1).at("point"), 4);
    EXPECT_EQ(pareto.at("points").at(5).at("on_front"), true);
    EXPECT_EQ(pareto.at("points").at(6).at("on_front"), false);
}

}  // namespace
}  // namespace foverig::sweep
