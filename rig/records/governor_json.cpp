#include "rig/records/governor_json.h"

namespace foverig {
namespace {

using nlohmann::json;

json or_null(const std::optional<double>& value) {
    return value ? json(*value) : json(nullptr);
}

}  // namespace

json governor_json(const RunRecord& run) {
    if (!run.governor || run.governor->settings.empty()) return nullptr;
    const auto& settings = run.governor->settings;
    std::vector<std::size_t> frames(settings.size());
    std::size_t governed = 0;
    std::size_t changes = 0;
    double error = 0.0;
    std::optional<std::uint32_t> before;
    for (const FrameRecord& frame : run.frames) {
        if (!frame.governor_setting) continue;
        ++governed;
        ++frames.at(*frame.governor_setting);
        error += settings[*frame.governor_setting].error.value_or(0.0);
        changes += before && *before != *frame.governor_setting;
        before = frame.governor_setting;
    }
    json governor = {{"error_name", run.governor->error_name},
                     {"limit_ms", run.governor->limit_ms},
                     {"changes", changes},
                     {"error_paid", nullptr},
                     {"error_dearest", or_null(settings.back().error)},
                     {"settings", json::array()}};
    if (governed > 0 && settings.back().error)
        governor["error_paid"] = error / static_cast<double>(governed);
    for (std::size_t i = 0; i < settings.size(); ++i)
        governor["settings"].push_back({{"settings", settings[i].text},
                                        {"ms", settings[i].ms},
                                        {"error", or_null(settings[i].error)},
                                        {"frames", frames[i]}});
    return governor;
}

}  // namespace foverig
