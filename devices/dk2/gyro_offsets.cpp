#include "devices/dk2/gyro_offsets.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "devices/dk2/detail/get_report.h"

namespace foverig::dk2 {
namespace {

constexpr double kApart_c = 1.0;     // nearer ones would make noise a slope (temperature.c)
constexpr double kBinWidth_c = 5.0;  // a line is believed so far beyond its ends
constexpr double kCentiC = 0.01;
constexpr int kMostCells = 256;  // a device that counts further is none of ours

OffsetAt offset_of(const TemperatureReport& cell) {
    return {kCentiC * cell.actual_centi_c, to_si(cell.gyro_offset)};
}

/// The newest sample of each bin, by temperature.
std::vector<OffsetAt> newest_of_bins(const std::vector<TemperatureReport>& cells) {
    std::map<int, TemperatureReport> newest;
    for (const TemperatureReport& cell : cells) {
        if (cell.version == 0) continue;
        const auto [known, added] = newest.try_emplace(cell.bin, cell);
        if (!added && cell.unix_time_s > known->second.unix_time_s) known->second = cell;
    }
    std::vector<OffsetAt> offsets;
    for (const auto& [bin, cell] : newest) offsets.push_back(offset_of(cell));
    std::sort(offsets.begin(), offsets.end(),
              [](const auto& a, const auto& b) { return a.temperature_c < b.temperature_c; });
    std::vector<OffsetAt> apart;
    for (const OffsetAt& offset : offsets) {
        if (apart.empty() || offset.temperature_c - apart.back().temperature_c >= kApart_c)
            apart.push_back(offset);
    }
    return apart;
}

}  // namespace

GyroOffsets::GyroOffsets(const dvec3& constant_rad_s, const std::vector<TemperatureReport>& cells,
                         const GyroOffsetReport& since_plugged_in)
    : constant_rad_s_(constant_rad_s), stored_(newest_of_bins(cells)) {
    if (since_plugged_in.version == 0) return;
    newest_ =
        OffsetAt{kCentiC * since_plugged_in.temperature_centi_c, to_si(since_plugged_in.offset)};
}

dvec3 GyroOffsets::by_table(double temperature_c) const {
    if (stored_.empty()) return constant_rad_s_;
    if (stored_.size() == 1) return stored_.front().rad_s;
    const double t_c = std::clamp(temperature_c, stored_.front().temperature_c - kBinWidth_c,
                                  stored_.back().temperature_c + kBinWidth_c);
    const auto above =
        std::upper_bound(stored_.begin() + 1, stored_.end() - 1, t_c,
                         [](double t, const OffsetAt& o) { return t < o.temperature_c; });
    const OffsetAt &b = *above, &a = *(above - 1);
    return glm::mix(a.rad_s, b.rad_s,
                    (t_c - a.temperature_c) / (b.temperature_c - a.temperature_c));
}

dvec3 GyroOffsets::at(double temperature_c) const {
    const dvec3 table = by_table(temperature_c);
    if (!newest_) return table;
    // The firmware prefers it within half a bin; here it fades, so that no rate ever jumps.
    const double away_c = std::abs(temperature_c - newest_->temperature_c);
    const double weight = std::max(0.0, 1.0 - away_c / kBinWidth_c);
    return table + weight * (newest_->rad_s - by_table(newest_->temperature_c));
}

Result<GyroOffsets> read_gyro_offsets(Transport& transport, const dvec3& constant_rad_s) {
    std::vector<TemperatureReport> cells;
    int count = 1;
    for (int i = 0; i < count; ++i) {
        const auto cell = detail::get_report<TemperatureReport>(transport);
        if (!cell) return cell.error();
        count = std::min(kMostCells, cell->bins * cell->samples_per_bin);
        cells.push_back(*cell);
    }
    const auto newest = detail::get_report<GyroOffsetReport>(transport);
    if (!newest) return newest.error();
    return GyroOffsets(constant_rad_s, cells, *newest);
}

}  // namespace foverig::dk2
