#include "devices/dk2/leds.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "devices/dk2/detail/get_report.h"
#include "devices/dk2/led_reports.h"

namespace foverig::dk2 {
namespace {

constexpr int kMostPoints = 256;  // a device that counts further is none of ours

/// By index; the device may begin at any.
template <class Report>
Result<std::vector<Report>> read_all(Transport& transport) {
    std::vector<std::optional<Report>> seen;
    for (int i = 0; i <= kMostPoints; ++i) {
        const auto report = detail::get_report<Report>(transport);
        if (!report) return report.error();
        const std::size_t count = report->count, index = report->index;
        if (seen.empty()) seen.resize(std::min<std::size_t>(count, kMostPoints));
        if (count != seen.size() || index >= count) break;
        if (seen[index]) {
            std::vector<Report> all;
            for (const auto& one : seen) {
                if (one) all.push_back(*one);
            }
            if (all.size() == seen.size()) return all;
            break;
        }
        seen[index] = *report;
    }
    return Error{ErrorCode::invalid_data,
                 fmt::format("DK2 feature report {} does not count through its indices; read "
                             "again, or set the LED table up anew",
                             Report::kId)};
}

dvec3 in_head_axes(const dvec3& v) {
    return {-v.x, v.y, -v.z};
}

dvec3 position_m(const PositionReport& r) {
    return 1e-6 * in_head_axes(dvec3(r.position_um[0], r.position_um[1], r.position_um[2]));
}

}  // namespace

Result<std::vector<Led>> read_leds(Transport& transport) {
    const auto positions = read_all<PositionReport>(transport);
    if (!positions) return positions.error();
    const auto patterns = read_all<PatternReport>(transport);
    if (!patterns) return patterns.error();
    const auto imu = std::find_if(positions->begin(), positions->end(), [](const auto& p) {
        return p.kind == PositionReport::Kind::imu;
    });
    if (imu == positions->end()) {
        return Error{ErrorCode::invalid_data,
                     "DK2 feature report 15 tells no place of the inertial sensor"};
    }
    std::vector<Led> leds;
    for (const PositionReport& p : *positions) {
        if (p.kind != PositionReport::Kind::led || p.index >= patterns->size()) continue;
        const dvec3 normal = in_head_axes(dvec3(p.normal[0], p.normal[1], p.normal[2]));
        if (glm::length(normal) == 0.0) continue;  // it could face anywhere
        leds.push_back({.position_m = position_m(p) - position_m(*imu),
                        .normal = glm::normalize(normal),
                        .code = (*patterns)[p.index].code()});
    }
    return leds;
}

}  // namespace foverig::dk2
