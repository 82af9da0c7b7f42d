#include "simulators/motion/recorded_eye.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "simulators/motion/csv.h"

namespace foverig::motion {
namespace {

const std::vector<std::string> kColumns{"t_s", "gaze_x_deg", "gaze_y_deg"};
const std::vector<std::string> kLidColumns{"t_s", "gaze_x_deg", "gaze_y_deg", "openness"};

EyeState state_of(const RecordedEye::Row& row) {
    return {.direction = direction_of(row.gaze_deg),
            .openness = row.openness,
            .blink = row.openness < 1.0};
}

}  // namespace

Result<RecordedEye> RecordedEye::load(const std::filesystem::path& file) {
    auto read = read_trajectory(file);
    if (!read) return read.error();
    const Table& table = *read;
    const bool has_lid = table.columns == kLidColumns;
    if (!has_lid && table.columns != kColumns) {
        return Error{ErrorCode::invalid_data,
                     fmt::format("{}: columns are '{}', expected 't_s,gaze_x_deg,gaze_y_deg' and "
                                 "perhaps ',openness'",
                                 file.string(), fmt::join(table.columns, ","))};
    }
    std::vector<Row> rows;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const auto& cell = table.rows[i];
        const double openness = has_lid ? cell[3] : 1.0;
        if (std::abs(cell[1]) > 90.0 || std::abs(cell[2]) > 90.0 || openness < 0.0 ||
            openness > 1.0) {
            return Error{ErrorCode::invalid_data,
                         fmt::format("{}:{}: gaze angles lie within 90 degrees and openness "
                                     "between 0 and 1",
                                     file.string(), table.lines[i])};
        }
        rows.push_back({cell[0], {cell[1], cell[2]}, openness});
    }
    return RecordedEye(std::move(rows));
}

EyeState RecordedEye::at(double t_s) const {
    const auto next = std::upper_bound(rows_.begin(), rows_.end(), t_s,
                                       [](double t, const Row& row) { return t < row.t_s; });
    if (next == rows_.begin()) return state_of(rows_.front());
    if (next == rows_.end()) return state_of(rows_.back());
    const Row& a = *(next - 1);
    const Row& b = *next;
    const double u = (t_s - a.t_s) / (b.t_s - a.t_s);
    return state_of(
        {t_s, glm::mix(a.gaze_deg, b.gaze_deg, u), a.openness + u * (b.openness - a.openness)});
}

}  // namespace foverig::motion
