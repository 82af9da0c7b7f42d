#include "rig/sweep/paper_section.h"

#include <fmt/format.h>

#include "rig/report/markup.h"
#include "rig/sweep/paper_chart.h"

namespace foverig::sweep {
namespace {

using nlohmann::json;
using report::escaped;
using report::number;

std::string cell(const json& value) {
    return value.is_number() ? number(value.get<double>()) : "–";
}

std::string with_interval(const json& ratio) {
    std::string text = cell(ratio.at("ours"));
    if (ratio.contains("ci95") && ratio.at("ci95").is_array())
        text +=
            fmt::format(" ({} to {})", cell(ratio.at("ci95").at(0)), cell(ratio.at("ci95").at(1)));
    return text;
}

/// Speed-up over ray cut: what overhead and lost coherence leave of the rays that were saved.
std::string kept_share(const json& row, const char* whose) {
    const json& speed_up = row.at("speed_up").at(whose);
    const json& ray_cut = row.at("ray_cut").at(whose);
    if (!speed_up.is_number() || !ray_cut.is_number()) return "–";
    return number(speed_up.get<double>() / ray_cut.get<double>());
}

std::string ratio_table(const json& paper) {
    std::vector<std::vector<std::string>> rows;
    for (const json& row : paper.at("rows")) {
        if (row.at("variant") == paper.at("baseline")) continue;
        rows.push_back({escaped(row.at("case").get<std::string>()),
                        escaped(row.at("variant").get<std::string>()),
                        cell(row.at("speed_up").at("theirs")), with_interval(row.at("speed_up")),
                        cell(row.at("ray_cut").at("theirs")), cell(row.at("ray_cut").at("ours")),
                        kept_share(row, "theirs"), kept_share(row, "ours")});
    }
    return report::table({"case", "variant", "speed-up, paper", "here (95 %)", "ray cut, paper",
                          "here", "speed-up / ray cut, paper", "here"},
                         rows, {2, 3, 4, 5, 6, 7});
}

std::vector<std::string> absolute_row(const json& row, const char* whose, std::size_t stages) {
    const json& numbers = row.at(whose);
    const bool ours = numbers.contains("ci95");
    std::vector<std::string> cells{ours ? "" : escaped(row.at("case").get<std::string>()),
                                   ours ? "" : escaped(row.at("variant").get<std::string>()),
                                   ours ? "here" : "paper"};
    if (!numbers.is_object()) {
        cells.resize(5 + stages, "–");
        cells.push_back("not given");
        return cells;
    }
    cells.push_back(cell(numbers.at("mrays")));
    std::string ms = cell(numbers.at("ms"));
    if (!ours && numbers.at("ms_error").is_number()) ms += " ± " + cell(numbers.at("ms_error"));
    cells.push_back(ms);
    const json& of_stages = numbers.at("stages_ms");
    for (std::size_t i = 0; i < stages; ++i)
        cells.push_back(i < of_stages.size() ? cell(of_stages.at(i)) : "–");
    cells.push_back(ours ? "measured" : escaped(numbers.at("read").get<std::string>()));
    return cells;
}

std::string absolute_table(const json& paper) {
    const json& stages = paper.at("stages");
    std::vector<std::string> heads{"case", "variant", "", "Mrays", "ms"};
    std::vector<std::size_t> numeric{3, 4};
    for (const json& stage : stages) {
        numeric.push_back(heads.size());
        heads.push_back(escaped(stage.at("name").get<std::string>()));
    }
    heads.emplace_back("from");
    std::vector<std::vector<std::string>> rows;
    for (const json& row : paper.at("rows")) {
        rows.push_back(absolute_row(row, "theirs", stages.size()));
        rows.push_back(absolute_row(row, "ours", stages.size()));
    }
    return report::table(heads, rows, numeric);
}

/// Which of our passes are which of the paper's stages, and what stands in for what.
std::string footnotes(const json& pareto) {
    std::string list;
    for (const json& one : pareto.at("cases"))
        if (const auto note = one.at("note").get<std::string>(); !note.empty())
            list += fmt::format("<li>{}: {}</li>", escaped(one.at("name").get<std::string>()),
                                escaped(note));
    for (const json& stage : pareto.at("paper").at("stages")) {
        std::string passes;
        for (const json& pass : stage.at("passes"))
            passes += fmt::format("{}<code>{}</code>", passes.empty() ? "" : ", ",
                                  escaped(pass.get<std::string>()));
        list += fmt::format("<li>{} here: {}</li>", escaped(stage.at("name").get<std::string>()),
                            passes.empty() ? "all other passes" : passes);
    }
    return list.empty() ? "" : "<ul class=\"note\">" + list + "</ul>";
}

}  // namespace

std::string paper_section(const json& pareto) {
    const json& paper = pareto.at("paper");
    std::string html = report::section(
        "Beside the paper",
        fmt::format("{}: {}. Two machines' milliseconds are no comparison; what each gains against "
                    "itself is, as far as scenes, flights and sizes agree. Speed-up is the time of "
                    "{} over the time of the variant, ours the mean over runs made one after the "
                    "other; ray cut is the same of rays.",
                    escaped(paper.at("source").get<std::string>()),
                    escaped(paper.at("conditions").get<std::string>()),
                    escaped(paper.at("baseline").get<std::string>())),
        paper_chart(paper) + paper_legend() + ratio_table(paper));
    html += report::section(
        "The numbers themselves, not to be compared",
        "The paper's are of its GPU, ours of the processor named above; sizes may differ. A ± is "
        "the reading error of a number taken off a plot; numbers without one are printed in the "
        "paper, or sums of such, as their last column says.",
        absolute_table(paper) + footnotes(pareto));
    return html;
}

}  // namespace foverig::sweep
