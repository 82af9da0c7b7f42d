#include "rig/sweep/read_paper.h"

#include <fmt/format.h>

#include "rig/text/nearest.h"

namespace foverig::sweep {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

json or_null(const std::optional<double>& value) {
    return value ? json(*value) : json(nullptr);
}

std::vector<std::string> case_names(const Sweep& sweep) {
    std::vector<std::string> names;
    for (const Case& one : sweep.cases) names.push_back(one.name);
    return names;
}

/// Those of the first case: all have the same.
std::vector<std::string> variant_names(const Sweep& sweep) {
    std::vector<std::string> names;
    for (const Point& point : sweep.points)
        if (point.of_case == 0) names.push_back(point.variant);
    return names;
}

std::string known(const fs::path& file, const toml::table& table, const TomlReader& reader,
                  const char* key, const std::vector<std::string>& names) {
    const std::string name = reader.text(key, "");
    if (std::find(names.begin(), names.end(), name) == names.end())
        refuse(file, table,
               fmt::format("{} is \"{}\"; expected a name of this sweep's, the nearest is {}", key,
                           name, nearest(name, names)));
    return name;
}

json stage_json(const fs::path& file, const toml::table& table) {
    const TomlReader reader(file, table, {"name", "passes"});
    return {{"name", reader.text("name", "")}, {"passes", reader.texts("passes")}};
}

json value_json(const fs::path& file, const toml::table& table, const Sweep& sweep,
                std::size_t stages) {
    const TomlReader reader(file, table,
                            {"case", "variant", "ms", "ms_error", "mrays", "stages_ms", "read"});
    json value = {{"case", known(file, table, reader, "case", case_names(sweep))},
                  {"variant", known(file, table, reader, "variant", variant_names(sweep))},
                  {"ms", or_null(reader.number("ms"))},
                  {"ms_error", or_null(reader.number("ms_error"))},
                  {"mrays", or_null(reader.number("mrays"))},
                  {"stages_ms", reader.numbers("stages_ms")},
                  {"read", reader.text("read", "")}};
    if (value["read"] == "") refuse(file, table, "expected read = \"where the numbers stand\"");
    if (!value["stages_ms"].empty() && value["stages_ms"].size() != stages)
        refuse(file, table,
               fmt::format("stages_ms has {} numbers; expected one for each of the {} stages",
                           value["stages_ms"].size(), stages));
    return value;
}

}  // namespace

json read_paper(const fs::path& file, const toml::table& table, const Sweep& sweep) {
    const TomlReader reader(file, table, {"source", "conditions", "baseline", "stages", "values"});
    if (sweep.cases.empty())
        refuse(file, table, "a paper's numbers belong to cases; expected [[cases]]");
    json paper = {{"source", reader.text("source", "")},
                  {"conditions", reader.text("conditions", "")},
                  {"baseline", known(file, table, reader, "baseline", variant_names(sweep))},
                  {"stages", json::array()},
                  {"values", json::array()}};
    for (const toml::table* stage : reader.tables("stages"))
        paper["stages"].push_back(stage_json(file, *stage));
    for (const toml::table* value : reader.tables("values"))
        paper["values"].push_back(value_json(file, *value, sweep, paper["stages"].size()));
    return paper;
}

}  // namespace foverig::sweep
