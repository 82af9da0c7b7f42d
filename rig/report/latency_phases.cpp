#include "rig/report/latency_phases.h"

#include <fmt/format.h>

#include <vector>

#include "rig/report/markup.h"

namespace foverig::report {
namespace {

using nlohmann::json;

std::string median_and_p99(const json& of_phase, const char* key, const char* unit) {
    if (!of_phase.contains(key) || !of_phase.at(key).is_object()) return "–";
    const json& spread = of_phase.at(key);
    return fmt::format("{} / {} {}", number(spread.at("p50").get<double>()),
                       number(spread.at("p99").get<double>()), unit);
}

std::vector<std::string> row(const char* what, const json& of_phase, const char* latency,
                             const char* error) {
    return {what, of_phase.at("frames").dump(), median_and_p99(of_phase, latency, "ms"),
            median_and_p99(of_phase, "head_lag", "ms"), median_and_p99(of_phase, error, "deg")};
}

}  // namespace

std::string latency_phases(const RunData& run) {
    if (!run.summary.contains("latency_by_phase")) return "";
    const json& phases = run.summary.at("latency_by_phase");
    const json& head = phases.at("head");
    const json& gaze = phases.at("gaze");
    std::vector<std::vector<std::string>> rows;
    const auto of_head = [&](const char* what, const char* phase) {
        rows.push_back(row(what, head.at(phase), "motion_to_photon", "prediction_error_deg"));
    };
    of_head("head: onset", "onset");
    of_head("head: moving on", "steady");
    of_head("head: at rest", "rest");
    rows.push_back(
        row("eyes: after a saccade began", gaze.at("onset"), "gaze_to_photon", "gaze_error_deg"));
    rows.push_back(row("eyes: else", gaze.at("steady"), "gaze_to_photon", "gaze_error_deg"));
    return fmt::format(
               "<p class=\"note\">Onset: until {} ms after the head began to turn faster than {} "
               "deg/s, or the eyes faster than {} deg/s. Lag: how long ago the head faced as the "
               "light shows it, after prediction; below 0 prediction went too far. Lag and errors "
               "need the truth, which simulated devices alone have.</p>",
               number(phases.at("onset_ms").get<double>()),
               number(phases.at("head_moves_deg_s").get<double>()),
               number(phases.at("eyes_move_deg_s").get<double>())) +
           table({"phase", "frames", "sample to photon, p50 / p99", "lag, p50 / p99",
                  "error, p50 / p99"},
                 rows, {1, 2, 3, 4});
}

}  // namespace foverig::report
