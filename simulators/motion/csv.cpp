#include "simulators/motion/csv.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string_view>

namespace foverig::motion {
namespace {

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlank = " \t\r";
    const auto first = text.find_first_not_of(kBlank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::vector<std::string_view> cells_of(std::string_view line) {
    std::vector<std::string_view> cells;
    while (true) {
        const auto comma = line.find(',');
        cells.push_back(trimmed(line.substr(0, comma)));
        if (comma == std::string_view::npos) return cells;
        line.remove_prefix(comma + 1);
    }
}

std::optional<double> number_of(std::string_view cell) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) {
        return std::nullopt;
    }
    return value;
}

Error bad(const std::filesystem::path& file, int line, const std::string& why) {
    return {ErrorCode::invalid_data, fmt::format("{}:{}: {}", file.string(), line, why)};
}

}  // namespace

Result<Table> read_trajectory(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::error_code ignored;
    if (!in || std::filesystem::is_directory(file, ignored)) {
        return Error{ErrorCode::not_found,
                     fmt::format("{}: cannot open this trajectory; give a model's name or a "
                                 "CSV file",
                                 file.string())};
    }
    Table table;
    std::string text;
    for (int line = 1; std::getline(in, text); ++line) {
        const std::string_view content = trimmed(text);
        if (content.empty() || content.front() == '#') continue;
        const auto cells = cells_of(content);
        if (table.columns.empty()) {
            table.columns.assign(cells.begin(), cells.end());
            continue;
        }
        if (cells.size() != table.columns.size()) {
            return bad(file, line,
                       fmt::format("{} cells, but the header names {} columns", cells.size(),
                                   table.columns.size()));
        }
        std::vector<double> row;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const auto value = number_of(cells[i]);
            if (!value) {
                return bad(file, line,
                           fmt::format("'{}' in column {} is not a finite number", cells[i],
                                       table.columns[i]));
            }
            row.push_back(*value);
        }
        if (!table.rows.empty() && row[0] <= table.rows.back()[0]) {
            return bad(
                file, line,
                fmt::format("time {} s does not come after {} s", row[0], table.rows.back()[0]));
        }
        table.rows.push_back(std::move(row));
        table.lines.push_back(line);
    }
    if (table.rows.size() < 2) {
        return Error{ErrorCode::invalid_data,
                     fmt::format("{}: {} rows of numbers, but a trajectory needs a header line "
                                 "and at least 2 rows",
                                 file.string(), table.rows.size())};
    }
    return table;
}

}  // namespace foverig::motion
