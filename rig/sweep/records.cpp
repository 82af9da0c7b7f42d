#include "rig/sweep/records.h"

#include <nlohmann/json.hpp>

namespace foverig::sweep {

const std::vector<std::string>& error_names() {
    static const std::vector<std::string> names{"absolute",    "flip",    "acuity",
                                                "flip_acuity", "fovea",   "periphery",
                                                "change",      "flicker", "fvvdp"};
    return names;
}

nlohmann::json to_json(const Accuracy& a) {
    return {{"kind", "accuracy"},
            {"point", a.point},
            {"errors", a.errors},
            {"rays", a.rays},
            {"sampled_pixel_ratio", a.sampled_pixel_ratio},
            {"backend_bytes", a.backend_bytes ? nlohmann::json(*a.backend_bytes) : nullptr},
            {"nan", a.nan}};
}

nlohmann::json to_json(const Times& t) {
    return {{"kind", "times"},
            {"point", t.point},
            {"repetition", t.repetition},
            {"frame_ms", t.frame_ms},
            {"pass_ms", t.pass_ms},
            {"elsewhere_processors",
             t.elsewhere_processors ? nlohmann::json(*t.elsewhere_processors) : nullptr}};
}

Accuracy accuracy_from(const nlohmann::json& json) {
    Accuracy a;
    json.at("point").get_to(a.point);
    json.at("errors").get_to(a.errors);
    json.at("rays").get_to(a.rays);
    json.at("sampled_pixel_ratio").get_to(a.sampled_pixel_ratio);
    const auto& bytes = json.at("backend_bytes");
    if (!bytes.is_null()) a.backend_bytes = bytes.get<std::uint64_t>();
    json.at("nan").get_to(a.nan);
    return a;
}

Times times_from(const nlohmann::json& json) {
    Times t;
    json.at("point").get_to(t.point);
    json.at("repetition").get_to(t.repetition);
    json.at("frame_ms").get_to(t.frame_ms);
    json.at("pass_ms").get_to(t.pass_ms);
    // A journal from before it was kept does not have it.
    const auto elsewhere = json.find("elsewhere_processors");
    if (elsewhere != json.end() && !elsewhere->is_null()) t.elsewhere_processors = *elsewhere;
    return t;
}

}  // namespace foverig::sweep
