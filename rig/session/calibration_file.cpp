#include "rig/session/calibration_file.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "rig/failure.h"

namespace foverig {
namespace {

using nlohmann::json;
using Targets = std::vector<gaze::CalibrationProcedure::Target>;

constexpr int kUnknownQuality = 255;

/// null where it is not known: JSON has no NaN. Four decimals are more than any tracker has.
json deg(double value) {
    if (!std::isfinite(value)) return nullptr;
    return std::round(1e4 * value) / 1e4;
}

json quality_json(const gaze::DataQuality& q) {
    return {{"accuracy_deg", deg(q.accuracy_deg)},
            {"rms_s2s_deg", deg(q.rms_s2s_deg)},
            {"sd_deg", deg(q.sd_deg)}};
}

json both_eyes(const gaze::Vec2f& values) {
    return {{"left", deg(static_cast<double>(values[0]))},
            {"right", deg(static_cast<double>(values[1]))}};
}

json points_json(const Targets& points) {
    json all = json::array();
    for (const auto& point : points) {
        all.push_back({{"x_deg", deg(point.at_deg.x)},
                       {"y_deg", deg(point.at_deg.y)},
                       {"attempts", point.attempts}});
    }
    return all;
}

json validation_json(const Targets& targets) {
    if (targets.empty()) return nullptr;
    json all = json::array();
    std::vector<gaze::DataQuality> left, right, combined;
    for (const auto& target : targets) {
        left.push_back(target.left);
        right.push_back(target.right);
        combined.push_back(target.combined);
        all.push_back({{"x_deg", deg(target.at_deg.x)},
                       {"y_deg", deg(target.at_deg.y)},
                       {"attempts", target.attempts},
                       {"samples", target.combined.samples},
                       {"left", quality_json(target.left)},
                       {"right", quality_json(target.right)},
                       {"combined", quality_json(target.combined)},
                       {"tracker_says",
                        {{"accuracy_deg", both_eyes(target.told_accuracy_deg)},
                         {"rms_s2s_deg", both_eyes(target.told_rms_s2s_deg)}}}});
    }
    return {{"mean",
             {{"left", quality_json(mean_of(left))},
              {"right", quality_json(mean_of(right))},
              {"combined", quality_json(mean_of(combined))}}},
            {"targets", all}};
}

std::string hex_of(Bytes bytes) {
    std::string text;
    for (const std::byte b : bytes) text += fmt::format("{:02x}", std::to_integer<unsigned>(b));
    return text;
}

/// Empty where it is not hexadecimal.
std::vector<std::byte> bytes_of(const std::string& hex) {
    std::vector<std::byte> bytes;
    for (std::size_t i = 0; i + 2 <= hex.size(); i += 2) {
        unsigned value = 0;
        const char* const begin = hex.data() + i;
        const auto [end, error] = std::from_chars(begin, begin + 2, value, 16);
        if (error != std::errc{} || end != begin + 2) return {};
        bytes.push_back(static_cast<std::byte>(value));
    }
    return bytes;
}

InputError refused(const std::string& name, const std::string& why) {
    return InputError(fmt::format(
        "{}: {}; expected a file that foverig calibrate wrote (tracking.gaze_calibration)", name,
        why));
}

}  // namespace

json calibration_json(const CalibrationRecord& record) {
    const int quality = record.status.calibration_quality;
    json calibration = {
        {"id", record.status.calibration_id},
        {"points", record.status.calibration_points},
        {"quality_percent", quality == kUnknownQuality ? json(nullptr) : json(quality)},
        {"accuracy_at_points_deg", both_eyes(record.outcome.accuracy_deg)},
        {"rms_s2s_at_points_deg", both_eyes(record.outcome.precision_deg)},
        {"targets", points_json(record.points)}};
    return {{"format", "foverig gaze calibration 1"},
            {"tracker", {{"serial", record.tracker.serial}, {"firmware", record.tracker.firmware}}},
            {"rate_hz", 0.1 * record.status.rate_decihertz},
            {"mapping_distance_mm", deg(static_cast<double>(record.status.mapping_mm))},
            {"calibration", calibration},
            {"validation", validation_json(record.validation)},
            {"tracker_data_hex", record.blob.empty() ? json(nullptr) : json(hex_of(record.blob))}};
}

gaze::StoredCalibration calibration_of(const std::string& content, const std::string& name) {
    const auto refuse = [&](const std::string& why) { throw refused(name, why); };
    const json all = json::parse(content, nullptr, false);
    if (!all.is_object()) refuse("is not JSON");
    if (all.contains("tracker_data_hex") && all["tracker_data_hex"].is_null())
        refuse("the tracker that it is of gives its calibration away to nobody");
    const auto text = [&](const json& from, const char* key) {
        if (!from.is_object() || !from.contains(key) || !from[key].is_string())
            refuse(fmt::format("has no text {}", key));
        return from[key].get<std::string>();
    };
    gaze::StoredCalibration stored{.serial = text(all.value("tracker", json()), "serial"),
                                   .blob = bytes_of(text(all, "tracker_data_hex"))};
    const auto blob = gaze::CalibrationBlob::decode(stored.blob);
    if (!blob) refuse("tracker_data_hex: " + blob.error().text);
    return stored;
}

gaze::StoredCalibration read_calibration(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream || std::filesystem::is_directory(file))
        throw refused(file.string(), "cannot be read");
    const std::string content{std::istreambuf_iterator<char>(stream), {}};
    return calibration_of(content, file.string());
}

gaze::GazeSourceConfig gaze_config(const Scenario& scenario) {
    if (!replayed_file(scenario).empty()) return {.rate_hz = 0};
    gaze::GazeSourceConfig config{.rate_hz =
                                      static_cast<std::uint16_t>(scenario.tracking.gaze_rate_hz)};
    const std::string& file = scenario.tracking.gaze_calibration;
    if (!file.empty()) config.calibration = read_calibration(file);
    return config;
}

}  // namespace foverig
