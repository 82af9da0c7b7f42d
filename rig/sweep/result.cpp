#include "rig/sweep/result.h"

#include <algorithm>

#include "rig/scenario/cost.h"
#include "rig/stats/centre.h"
#include "rig/sweep/front.h"
#include "rig/sweep/paper_result.h"
#include "rig/sweep/point_result.h"
#include "rig/sweep/prices.h"

namespace foverig::sweep {
namespace {

using Json = nlohmann::ordered_json;

struct PointResult {
    PointTimes times;
    std::map<std::string, PointErrors> errors;
    double budget_ms = 0.0;
};

Json to_json(const std::optional<stats::Interval>& interval) {
    return interval ? Json{interval->low, interval->high} : Json(nullptr);
}

Json to_json(const stats::Percentile& p) {
    Json json = {{"value", nullptr},
                 {"ci95", nullptr},
                 {"effective_n", p.effective_n},
                 {"needed_n", p.needed_n}};
    if (p.estimate) {
        json["value"] = p.estimate->value;
        json["ci95"] = to_json(p.estimate->ci95);
    }
    return json;
}

Json to_json(const PointTimes& times) {
    Json json = {{"value", times.ms.value}, {"ci95", to_json(times.ms.ci95)},
                 {"runs", times.runs_ms},   {"p50", nullptr},
                 {"p90", nullptr},          {"p99", nullptr}};
    constexpr const char* kNames[] = {"p50", "p90", "p99"};
    for (std::size_t i = 0; i < times.percentiles.size(); ++i)
        json[kNames[i]] = to_json(times.percentiles[i]);
    return json;
}

Json to_json(const std::map<std::string, PointErrors>& errors) {
    Json json = Json::object();
    for (const auto& [name, error] : errors)
        json[name] = {{"mean", error.mean.value},
                      {"ci95", to_json(error.mean.ci95)},
                      {"p50", to_json(error.percentiles.at(0))},
                      {"p90", to_json(error.percentiles.at(1))},
                      {"max", error.worst}};
    return json;
}

/// A VSync of this point, whose rate may be a knob.
double budget_ms(const nlohmann::json& definition, const nlohmann::json& settings) {
    const double base_hz = definition.at("scenario").at("display").at("rate_hz").get<double>();
    return 1000.0 / settings.value("display.rate_hz", base_hz);
}

PointResult result_of(const Measured& measured, std::size_t point) {
    const auto& definition = measured.definition;
    const auto warm_up = definition.at("warm_up_frames").get<std::size_t>();
    PointResult result;
    result.budget_ms = budget_ms(definition, definition.at("points").at(point));
    result.errors = errors_of(measured.accuracies.at(point), warm_up);
    const auto cost = parse_cost(definition.at("scenario").at("cost").get<std::string>());
    result.times = cost && cost->fixed_ms
                       ? modelled_times(*cost->fixed_ms, result.budget_ms)
                       : times_of(measured.times.at(point), warm_up, result.budget_ms);
    return result;
}

Json point_json(const Measured& measured, std::size_t point, const PointResult& result) {
    const Accuracy& accuracy = measured.accuracies.at(point);
    Json json = {
        {"point", point},
        {"settings", measured.definition.at("points").at(point)},
        {"default", measured.definition.at("default_point") == point},
        {"on_front", false},
        {"time_ms", to_json(result.times)},
        {"error", to_json(result.errors)},
        {"vsync", {{"budget_ms", result.budget_ms}, {"missed_ratio", result.times.missed_ratio}}},
        {"pass_time_ms", result.times.pass_ms},
        {"rays", accuracy.rays},
        {"sampled_pixel_ratio", accuracy.sampled_pixel_ratio},
        {"memory",
         {{"backend_bytes", accuracy.backend_bytes ? Json(*accuracy.backend_bytes) : nullptr}}},
        {"numerics", {{"nan", accuracy.nan}}}};
    if (measured.definition.contains("cases")) {
        const auto of_case = measured.definition.at("point_cases").at(point).get<std::size_t>();
        json["case"] = measured.definition.at("cases").at(of_case).at("name");
        json["variant"] = measured.definition.at("point_variants").at(point);
    }
    return json;
}

Json front_json(const std::vector<Place>& places, const std::vector<std::size_t>& front) {
    Json json = Json::array();
    for (std::size_t i = 0; i < front.size(); ++i) {
        const Place& here = places[front[i]];
        json.push_back({{"point", front[i]},
                        {"time_ms", here.ms},
                        {"error", here.error},
                        {"to_next", nullptr}});
        if (i + 1 == front.size()) break;
        const Place& next = places[front[i + 1]];
        const double ms = next.ms - here.ms;
        const double error = next.error - here.error;
        json.back()["to_next"] = {{"ms", ms}, {"error", error}, {"error_per_ms", error / ms}};
    }
    return json;
}

Json within_json(const std::vector<Place>& places, const std::vector<std::size_t>& front,
                 const nlohmann::json& errors) {
    Json json = Json::array();
    for (const auto& error : errors) {
        json.push_back({{"error", error}, {"point", nullptr}, {"time_ms", nullptr}});
        if (const auto found = cheapest_within(places, front, error.get<double>())) {
            json.back()["point"] = *found;
            json.back()["time_ms"] = places[*found].ms;
        }
    }
    return json;
}

/// Of all timed runs: how many of the machine's processors others had.
Json elsewhere_json(const Measured& measured) {
    std::vector<double> processors;
    for (const auto& [point, runs] : measured.times)
        for (const Times& run : runs)
            if (run.elsewhere_processors) processors.push_back(*run.elsewhere_processors);
    if (processors.empty()) return nullptr;
    return {{"p50", stats::median_of(processors)}, {"max", std::ranges::max(processors)}};
}

/// A front of each case: settings of two scenes are no choice between each other.
Json cases_json(const nlohmann::json& definition, const std::vector<Place>& places, Json& points) {
    Json cases = Json::array();
    for (std::size_t i = 0; i < definition.at("cases").size(); ++i) {
        std::vector<std::size_t> numbers;
        std::vector<Place> of_case;
        for (std::size_t point = 0; point < places.size(); ++point)
            if (definition.at("point_cases").at(point) == i) {
                numbers.push_back(point);
                of_case.push_back(places[point]);
            }
        const std::vector<std::size_t> front = front_of(of_case);
        Json steps = front_json(of_case, front);
        for (Json& step : steps) step["point"] = numbers[step["point"].get<std::size_t>()];
        for (const std::size_t place : front) points[numbers[place]]["on_front"] = true;
        const auto& one = definition.at("cases").at(i);
        cases.push_back({{"name", one.at("name")},
                         {"note", one.at("note")},
                         {"points", numbers},
                         {"front", std::move(steps)}});
    }
    return cases;
}

}  // namespace

Json pareto_json(const Measured& measured) {
    const auto& definition = measured.definition;
    const auto axis = definition.at("error").get<std::string>();
    std::vector<Place> places;
    Json points = Json::array();
    for (std::size_t point = 0; point < design_points(definition); ++point) {
        const PointResult result = result_of(measured, point);
        places.push_back({result.times.ms.value, result.errors.at(axis).mean.value});
        points.push_back(point_json(measured, point, result));
    }
    const bool one_case = !definition.contains("cases");
    const std::vector<std::size_t> front = one_case ? front_of(places) : std::vector<std::size_t>{};
    Json cases = one_case ? Json(nullptr) : cases_json(definition, places, points);
    const Json paper =
        definition.contains("paper") ? paper_json(definition, points) : Json(nullptr);
    for (const std::size_t point : front) points[point]["on_front"] = true;
    Json hosts = Json::array();
    for (const auto& host : measured.hosts) hosts.push_back(Json(host));
    Json pareto = {{"schema", "foverig.pareto/1"},
                   {"sweep", definition},
                   {"build", measured.build},
                   {"hosts", std::move(hosts)},
                   {"modelled", definition.at("fixed_cost")},
                   {"elsewhere_processors", elsewhere_json(measured)},
                   {"error", axis},
                   {"budget_ms", budget_ms(definition, nlohmann::json::object())},
                   {"points", std::move(points)},
                   {"front", front_json(places, front)},
                   {"cheapest_within", within_json(places, front, definition.at("within"))}};
    if (!one_case) pareto["cases"] = std::move(cases);
    if (!paper.is_null()) pareto["paper"] = paper;
    if (definition.contains("price_points")) pareto["prices"] = prices_json(measured);
    return pareto;
}

}  // namespace foverig::sweep
