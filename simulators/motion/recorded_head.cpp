#include "simulators/motion/recorded_head.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "devices/fusion/rotation.h"
#include "simulators/motion/csv.h"

namespace foverig::motion {
namespace {

const std::vector<std::string> kTurnColumns{"t_s", "qw", "qx", "qy", "qz"};
const std::vector<std::string> kMoveColumns{"t_s", "qw", "qx", "qy", "qz", "x_m", "y_m", "z_m"};

}  // namespace

Result<RecordedHead> RecordedHead::load(const std::filesystem::path& file) {
    auto read = read_trajectory(file);
    if (!read) return read.error();
    const Table& table = *read;
    const bool has_position = table.columns == kMoveColumns;
    if (!has_position && table.columns != kTurnColumns) {
        return Error{ErrorCode::invalid_data,
                     fmt::format("{}: columns are '{}', expected 't_s,qw,qx,qy,qz' and perhaps "
                                 "',x_m,y_m,z_m'",
                                 file.string(), fmt::join(table.columns, ","))};
    }
    std::vector<Row> rows;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const auto& cell = table.rows[i];
        const dquat q(cell[1], cell[2], cell[3], cell[4]);
        if (std::abs(glm::length(q) - 1.0) > 0.01) {
            return Error{ErrorCode::invalid_data,
                         fmt::format("{}:{}: the quaternion's length is {:.4f}, expected 1",
                                     file.string(), table.lines[i], glm::length(q))};
        }
        rows.push_back({cell[0], glm::normalize(q),
                        has_position ? dvec3(cell[5], cell[6], cell[7]) : dvec3(0.0)});
    }
    return RecordedHead(std::move(rows), has_position);
}

RecordedHead::RecordedHead(std::vector<Row> rows, bool has_position)
    : rows_(std::move(rows)), has_position_(has_position) {
    for (std::size_t i = 0; i + 1 < rows_.size(); ++i) {
        const dquat step = glm::conjugate(rows_[i].world_from_head) * rows_[i + 1].world_from_head;
        segment_velocity_rad_s_.push_back(log_map(step) / (rows_[i + 1].t_s - rows_[i].t_s));
    }
}

HeadState RecordedHead::rest(const Row& row) const {
    HeadState head;
    head.world_from_head = row.world_from_head;
    hang_on_neck(head);
    if (has_position_) head.position_m = row.position_m;
    return head;
}

HeadState RecordedHead::at(double t_s) const {
    if (t_s < start_s()) return rest(rows_.front());
    if (t_s >= end_s()) return rest(rows_.back());
    const auto next = std::upper_bound(rows_.begin(), rows_.end(), t_s,
                                       [](double t, const Row& row) { return t < row.t_s; });
    const auto i = static_cast<std::size_t>(next - rows_.begin()) - 1;
    HeadState head;
    head.angular_velocity_rad_s = segment_velocity_rad_s_[i];
    head.world_from_head =
        rows_[i].world_from_head * exp_map((t_s - rows_[i].t_s) * head.angular_velocity_rad_s);
    // The velocity steps at each row; its slope over the neighbours is what an accelerometer on a
    // lever would have felt.
    const std::size_t before = i > 0 ? i - 1 : i;
    const std::size_t after = std::min(i + 1, segment_velocity_rad_s_.size() - 1);
    if (after > before) {
        const double middle_before_s = 0.5 * (rows_[before].t_s + rows_[before + 1].t_s);
        const double middle_after_s = 0.5 * (rows_[after].t_s + rows_[after + 1].t_s);
        head.angular_acceleration_rad_s2 =
            (segment_velocity_rad_s_[after] - segment_velocity_rad_s_[before]) /
            (middle_after_s - middle_before_s);
    }
    if (has_position_) {
        move(head, i, t_s);
    } else {
        hang_on_neck(head);
    }
    return head;
}

dvec3 RecordedHead::row_velocity_m_s(std::size_t row) const {
    const Row& before = rows_[row > 0 ? row - 1 : row];
    const Row& after = rows_[std::min(row + 1, rows_.size() - 1)];
    return (after.position_m - before.position_m) / (after.t_s - before.t_s);
}

void RecordedHead::move(HeadState& head, std::size_t i, double t_s) const {
    const double span_s = rows_[i + 1].t_s - rows_[i].t_s;
    const double u = (t_s - rows_[i].t_s) / span_s;
    const dvec3 p = rows_[i].position_m, d = rows_[i + 1].position_m - p;
    const dvec3 m0 = span_s * row_velocity_m_s(i), m1 = span_s * row_velocity_m_s(i + 1);
    const dvec3 square = 3.0 * d - 2.0 * m0 - m1, cube = m0 + m1 - 2.0 * d;
    head.position_m = p + u * (m0 + u * (square + u * cube));
    head.acceleration_m_s2 = (2.0 * square + 6.0 * u * cube) / (span_s * span_s);
}

}  // namespace foverig::motion
