#include "rig/report/governor_chart.h"

#include <fmt/format.h>

#include "rig/report/markup.h"
#include "rig/report/svg.h"

namespace foverig::report {
namespace {

using nlohmann::json;

constexpr double kWidth = 1000.0, kLeft = 52.0, kRight = kWidth - 12.0, kTop = 10.0, kBottom = 30.0,
                 kRow = 22.0;

std::optional<double> number_at(const json& object, const char* key) {
    return object.at(key).is_number() ? std::optional(object.at(key).get<double>()) : std::nullopt;
}

std::string steps(const std::vector<std::optional<double>>& chosen, std::size_t settings) {
    const double height = kTop + kBottom + kRow * static_cast<double>(settings);
    Svg svg(kWidth, height, "The governor's setting of every frame, the dearest on top");
    const Scale y{-0.5, static_cast<double>(settings) - 0.5, height - kBottom, kTop};
    const Scale x{0.0, static_cast<double>(chosen.size()), kLeft, kRight};
    for (std::size_t i = 0; i < settings; ++i) {
        const auto row = static_cast<double>(i);
        svg.line({kLeft, y(row)}, {kRight, y(row)}, "grid");
        svg.text({kLeft - 8, y(row) + 4}, fmt::format("{}", i), "axis", "end");
    }
    for (const double tick : ticks(static_cast<double>(chosen.size()), 10))
        svg.text({x(tick), height - kBottom + 16}, fmt::format("{:g}", tick), "axis", "middle");
    svg.text({(kLeft + kRight) / 2, height - 3}, "frame", "axis", "middle");
    std::vector<Point> line;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        if (!chosen[i]) continue;
        if (line.empty() || line.back().y != y(*chosen[i]))
            line.push_back({x(static_cast<double>(i)), y(*chosen[i])});
        const bool last = i + 1 == chosen.size() || chosen[i + 1] != chosen[i];
        if (last) line.push_back({x(static_cast<double>(i + 1)), y(*chosen[i])});
    }
    svg.polyline(line, "governed");
    return svg.str();
}

}  // namespace

std::string governor_chart(const RunData& run) {
    const json governor = run.summary.value("governor", json());
    if (!governor.is_object()) return {};
    const json& settings = governor.at("settings");
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = settings.size(); i-- > 0;) {
        const json& setting = settings[i];
        rows.push_back({fmt::format("{}", i), escaped(setting.at("settings").get<std::string>()),
                        number(number_at(setting, "ms")), number(number_at(setting, "error")),
                        count(number_at(setting, "frames"))});
    }
    const auto paid = number_at(governor, "error_paid");
    const std::string price =
        paid ? fmt::format(", at a mean {} of {}; the dearest setting alone has {}",
                           escaped(governor.at("error_name").get<std::string>()), number(paid),
                           number(number_at(governor, "error_dearest")))
             : "";
    return fmt::format("<p>{} changes in {} frames{}. Frames were to stay below {} ms.</p>",
                       count(number_at(governor, "changes")), run.frames.frames, price,
                       number(number_at(governor, "limit_ms"))) +
           steps(run.frames.column("governor_setting"), settings.size()) +
           table({"setting", "is", "ms where measured", "error there", "frames"}, rows,
                 {0, 2, 3, 4});
}

}  // namespace foverig::report
