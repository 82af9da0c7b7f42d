#include "rig/records/frame_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace foverig {

std::string frame_json(const FrameRecord& frame) {
    auto json = nlohmann::ordered_json::object();
    for (const Column& column : frame_columns()) {
        const Cell cell = column.value(frame);
        auto& value = json[column.id];
        if (const auto* integer = std::get_if<std::int64_t>(&cell)) value = *integer;
        if (const auto* number = std::get_if<double>(&cell)) value = *number;
    }
    return json.dump();
}

std::string frame_json_schema() {
    auto properties = nlohmann::ordered_json::object();
    for (const Column& column : frame_columns()) {
        auto& property = properties[column.id];
        property["type"] = "number";
        const std::string unit = column.unit.empty() ? "" : fmt::format(" ({})", column.unit);
        if (!column.definition.empty()) property["description"] = column.definition + unit;
    }
    return nlohmann::ordered_json{
        {"type", "object"}, {"title", "foverig.FrameRecord"}, {"properties", properties}}
        .dump();
}

}  // namespace foverig
