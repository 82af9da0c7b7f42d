#include "rig/sweep/paper_result.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "rig/stats/centre.h"
#include "rig/stats/student_t.h"

namespace foverig::sweep {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kRaysOfMrays = 1.0e6;

/// Null where the paper has no numbers of that.
Json theirs_of(const Json& paper, const std::string& case_name, const std::string& variant) {
    for (const Json& value : paper.at("values"))
        if (value.at("case") == case_name && value.at("variant") == variant) return value;
    return nullptr;
}

/// Our passes summed as the paper sums its own; a stage without passes has all that no other has.
Json stages_of(const Json& stages, const Json& pass_time_ms) {
    std::set<std::string> claimed;
    for (const Json& stage : stages)
        for (const Json& pass : stage.at("passes")) claimed.insert(pass.get<std::string>());
    Json sums = Json::array();
    for (const Json& stage : stages) {
        const Json& passes = stage.at("passes");
        double ms = 0.0;
        for (const auto& [pass, pass_ms] : pass_time_ms.items()) {
            const bool of_stage =
                passes.empty() ? !claimed.contains(pass)
                               : std::find(passes.begin(), passes.end(), pass) != passes.end();
            if (of_stage) ms += pass_ms.get<double>();
        }
        sums.push_back(ms);
    }
    return sums;
}

Json ours_of(const Json& paper, const Json& point) {
    return {{"ms", point.at("time_ms").at("value")},
            {"ci95", point.at("time_ms").at("ci95")},
            {"mrays", point.at("rays").at("total").get<double>() / kRaysOfMrays},
            {"stages_ms", stages_of(paper.at("stages"), point.at("pass_time_ms"))}};
}

/// Null where one of them is not known or 0.
Json ratio(const Json& above, const Json& below, const char* key) {
    if (!above.is_object() || !below.is_object()) return nullptr;
    const Json& a = above.at(key);
    const Json& b = below.at(key);
    if (!a.is_number() || !b.is_number() || b.get<double>() == 0.0) return nullptr;
    return a.get<double>() / b.get<double>();
}

/// Of the runs that were made one after the other; null at fixed cost.
Json our_speed_up(const Json& baseline, const Json& point) {
    const auto before = baseline.at("time_ms").at("runs").get<std::vector<double>>();
    const auto after = point.at("time_ms").at("runs").get<std::vector<double>>();
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i)
        ratios.push_back(before[i] / after[i]);
    if (ratios.empty()) return {{"ours", nullptr}, {"ci95", nullptr}};
    const auto interval = stats::mean_interval(ratios);
    return {{"ours", stats::mean_of(ratios)},
            {"ci95", interval ? Json{interval->low, interval->high} : Json(nullptr)}};
}

const Json& baseline_of(const Json& points, const Json& point, const Json& variant) {
    return *std::find_if(points.begin(), points.end(), [&](const Json& other) {
        return other.at("case") == point.at("case") && other.at("variant") == variant;
    });
}

}  // namespace

Json paper_json(const nlohmann::json& definition, const Json& points) {
    const Json paper = definition.at("paper");
    Json rows = Json::array();
    for (const Json& point : points) {
        const auto case_name = point.at("case").get<std::string>();
        const Json& baseline = baseline_of(points, point, paper.at("baseline"));
        const Json theirs = theirs_of(paper, case_name, point.at("variant").get<std::string>());
        const Json their_baseline =
            theirs_of(paper, case_name, paper.at("baseline").get<std::string>());
        const Json ours = ours_of(paper, point);
        Json speed_up = our_speed_up(baseline, point);
        speed_up["theirs"] = ratio(their_baseline, theirs, "ms");
        rows.push_back({{"case", case_name},
                        {"variant", point.at("variant")},
                        {"point", point.at("point")},
                        {"theirs", theirs},
                        {"ours", ours},
                        {"speed_up", std::move(speed_up)},
                        {"ray_cut",
                         {{"theirs", ratio(their_baseline, theirs, "mrays")},
                          {"ours", ratio(ours_of(paper, baseline), ours, "mrays")}}}});
    }
    return {{"source", paper.at("source")},
            {"conditions", paper.at("conditions")},
            {"baseline", paper.at("baseline")},
            {"stages", paper.at("stages")},
            {"rows", std::move(rows)}};
}

}  // namespace foverig::sweep
