#include "rig/records/frames_csv.h"

#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <sstream>

#include "rig/failure.h"
#include "rig/records/columns.h"

namespace foverig {
namespace {

std::string text_of(const Cell& cell) {
    if (const auto* integer = std::get_if<std::int64_t>(&cell)) return fmt::format("{}", *integer);
    if (const auto* number = std::get_if<double>(&cell)) return fmt::format("{}", *number);
    return "NA";
}

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    return cells;
}

std::optional<double> number_of(const std::string& cell, const std::string& where) {
    if (cell == "NA") return std::nullopt;
    double value = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc{} || end != cell.data() + cell.size()) {
        throw InputError(fmt::format("{}: \"{}\" is neither a number nor NA", where, cell));
    }
    return value;
}

}  // namespace

std::string frames_csv(const std::vector<FrameRecord>& frames, WallTimes wall_times) {
    std::vector<Column> columns = frame_columns();
    if (wall_times == WallTimes::keep) {
        for (auto& column : wall_columns(frames)) columns.push_back(std::move(column));
    }
    std::string text;
    for (const Column& column : columns) text += column.id + ',';
    text.back() = '\n';
    for (const FrameRecord& frame : frames) {
        for (const Column& column : columns) text += text_of(column.value(frame)) + ',';
        text.back() = '\n';
    }
    return text;
}

std::vector<std::optional<double>> FrameTable::column(const std::string& id) const {
    const auto found = columns.find(id);
    return found == columns.end() ? std::vector<std::optional<double>>(frames) : found->second;
}

FrameTable read_frames_csv(const std::filesystem::path& file) {
    std::ifstream stream(file);
    std::string line;
    if (!stream || !std::getline(stream, line)) {
        throw InputError(fmt::format("{}: cannot be read; expected the frames.csv of a run folder",
                                     file.string()));
    }
    FrameTable table;
    table.order = split(line);
    std::vector<std::vector<std::optional<double>>*> columns;
    for (const std::string& id : table.order) columns.push_back(&table.columns[id]);
    while (std::getline(stream, line)) {
        const std::string where = fmt::format("{}:{}", file.string(), table.frames + 2);
        const auto cells = split(line);
        if (cells.size() != columns.size()) {
            throw InputError(fmt::format("{}: {} cells; the header has {}", where, cells.size(),
                                         columns.size()));
        }
        for (std::size_t i = 0; i < cells.size(); ++i) {
            columns[i]->push_back(number_of(cells[i], where));
        }
        ++table.frames;
    }
    return table;
}

}  // namespace foverig
