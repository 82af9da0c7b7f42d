// The exports that are text: read back by what their readers look for.
#include "rig/exports/formats.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "rig/exports/benchmark_json.h"
#include "tests/rig/exports/some_run.h"

namespace foverig::exports {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

class Exports : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) / ("exports_test_" + std::to_string(getpid()));
        run_ = test::some_run(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    static std::vector<std::vector<std::string>> cells_of(const std::string& csv) {
        std::vector<std::vector<std::string>> rows;
        std::istringstream lines(csv);
        for (std::string line; std::getline(lines, line);) {
            std::istringstream cells(line);
            rows.emplace_back();
            for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
        }
        return rows;
    }

    fs::path folder_;
    report::RunData run_;
};

TEST_F(Exports, HavePresentMonsColumnsAndIntervals) {
    const auto rows = cells_of(format_of("presentmon").text(run_));
    ASSERT_EQ(rows.size(), 12U) << "a present that has none before it is left out";
    const auto column = [&](const std::string& name) {
        const auto at = std::find(rows[0].begin(), rows[0].end(), name);
        EXPECT_NE(at, rows[0].end()) << name;
        return static_cast<std::size_t>(at - rows[0].begin());
    };
    for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
    EXPECT_EQ(rows[1][column("msBetweenPresents")], "13.000000");
    EXPECT_EQ(rows[1][column("msUntilDisplayed")], "4.000000");
    EXPECT_EQ(rows[1][column("msUntilRenderComplete")], "-1.000000");
    EXPECT_EQ(rows[2][column("TimeInSeconds")], "0.026000000");
    EXPECT_EQ(rows[6][column("Dropped")], "1");
    EXPECT_EQ(rows[6][column("msUntilDisplayed")], "0.000000");
    EXPECT_EQ(rows[7][column("msBetweenDisplayChange")], "26.000000");
    double sum_ms = 0.0;
    for (std::size_t i = 1; i < rows.size(); ++i)
        sum_ms += std::stod(rows[i][column("msBetweenDisplayChange")]);
    EXPECT_NEAR(sum_ms, 13.0 * 11, 1e-6);
}

TEST_F(Exports, AreBenchmarksWithTheKeysThatComparePyReads) {
    const json both = json::parse(benchmark_json({run_, run_}).dump());
    EXPECT_TRUE(both.at("context").is_object());
    std::size_t frame_times = 0;
    for (const json& benchmark : both.at("benchmarks")) {
        EXPECT_EQ(benchmark.at("run_type"), "iteration");
        EXPECT_EQ(benchmark.at("time_unit"), "us");
        EXPECT_EQ(benchmark.at("repetitions"), 2);
        const bool whole_frame = benchmark.at("name") == "atrium/full/frame_time";
        if (!whole_frame) {
            EXPECT_EQ(benchmark.at("real_time"), benchmark.at("cpu_time"));
        } else {
            EXPECT_NEAR(benchmark.at("real_time").get<double>(), 9000.0, 1e-9);
            EXPECT_NEAR(benchmark.at("cpu_time").get<double>(), 14000.0, 1e-9);
            EXPECT_EQ(benchmark.at("repetition_index"), frame_times++);
        }
        if (benchmark.at("name") == "atrium/full/pass/shade") {
            EXPECT_NEAR(benchmark.at("real_time").get<double>(), 2500.0, 1e-9);
        }
    }
    EXPECT_EQ(frame_times, 2U);
}

TEST_F(Exports, AreMarkdownWhoseTablesHoldTogether) {
    const std::string text = format_of("markdown").text(run_);
    EXPECT_THAT(text, testing::StartsWith("### foverig: atrium, full on embree\n"));
    EXPECT_THAT(text, HasSubstr("| VSyncs missed |"));
    EXPECT_THAT(text, HasSubstr("| area_light | 1.25 | 2 lights \\| <b> |"));
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("|")) continue;
        std::size_t bars = 0;
        for (std::size_t i = 0; i < line.size(); ++i)
            bars += line[i] == '|' && (i == 0 || line[i - 1] != '\\');
        EXPECT_EQ(bars, 4U) << line;
    }
}

TEST_F(Exports, KnowTheirNames) {
    EXPECT_EQ(format_of("perfetto").file, "trace.pftrace");
    EXPECT_THROW(format_of("paper"), std::invalid_argument);
}

}  // namespace
}  // namespace foverig::exports
