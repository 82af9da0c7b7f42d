#include "rig/sweep/prices.h"

#include <algorithm>

#include "rig/stats/bootstrap.h"
#include "rig/stats/centre.h"
#include "rig/stats/student_t.h"

namespace foverig::sweep {
namespace {

using Json = nlohmann::ordered_json;

Json estimated(double value, const std::optional<stats::Interval>& ci95) {
    return {{"value", value}, {"ci95", ci95 ? Json{ci95->low, ci95->high} : Json(nullptr)}};
}

/// Medians of a point's runs, in the order of repetitions.
std::vector<double> run_medians(const std::vector<Times>& runs, std::size_t warm_up_frames) {
    std::vector<double> medians;
    for (const Times& run : runs)
        medians.push_back(stats::median_of(
            std::span(run.frame_ms).subspan(std::min(warm_up_frames, run.frame_ms.size() - 1))));
    return medians;
}

std::vector<double> differences(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> all;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) all.push_back(a[i] - b[i]);
    return all;
}

Json ms_of(const Measured& measured, std::size_t base, std::size_t without) {
    if (measured.definition.at("fixed_cost").get<bool>()) return nullptr;
    const auto warm_up = measured.definition.at("warm_up_frames").get<std::size_t>();
    const auto added = differences(run_medians(measured.times.at(base), warm_up),
                                   run_medians(measured.times.at(without), warm_up));
    return estimated(stats::mean_of(added), stats::mean_interval(added));
}

Json error_of(const Measured& measured, std::size_t base, std::size_t without) {
    const auto axis = measured.definition.at("error").get<std::string>();
    const auto warm_up = measured.definition.at("warm_up_frames").get<std::size_t>();
    auto removed = differences(measured.accuracies.at(without).errors.at(axis),
                               measured.accuracies.at(base).errors.at(axis));
    removed.erase(removed.begin(), removed.begin() + static_cast<std::ptrdiff_t>(
                                                         std::min(warm_up, removed.size() - 1)));
    return estimated(stats::mean_of(removed), stats::bootstrap_interval(removed, stats::mean_of));
}

std::string left_out_by(const std::string& effect) {
    return effect == "reprojection" ? "pipeline = full" : "effects." + effect + " = off";
}

}  // namespace

void add_price_points(Sweep& sweep, const EffectPlan& plan) {
    const Settings base = sweep.points.at(sweep.default_point.value()).settings;
    for (const PlannedEffect& effect : plan.effects()) {
        if (!effect.on) continue;
        Settings settings = base;
        if (effect.name == "reprojection")
            settings.emplace_back("pipeline", std::string("full"));
        else if (follows_from(effect.name).empty())
            settings.emplace_back("effects." + effect.name, std::string("off"));
        else
            continue;
        sweep.price_points[effect.name] = sweep.points.size();
        sweep.points.push_back({settings, with_settings(sweep.base, settings)});
    }
}

std::size_t design_points(const nlohmann::json& definition) {
    const std::size_t all = definition.at("points").size();
    return definition.contains("price_points") ? all - definition.at("price_points").size() : all;
}

Json prices_json(const Measured& measured) {
    const auto base = measured.definition.at("default_point").get<std::size_t>();
    std::vector<Json> prices;
    for (const auto& [effect, number] : measured.definition.at("price_points").items()) {
        const auto without = number.get<std::size_t>();
        Json price = {{"effect", effect},
                      {"left_out", left_out_by(effect)},
                      {"ms", ms_of(measured, base, without)},
                      {"error", error_of(measured, base, without)},
                      {"error_per_ms", nullptr}};
        if (price["ms"].is_object() && price["ms"]["value"] != 0.0)
            price["error_per_ms"] =
                price["error"]["value"].get<double>() / price["ms"]["value"].get<double>();
        prices.push_back(std::move(price));
    }
    std::stable_sort(prices.begin(), prices.end(), [](const Json& a, const Json& b) {
        const auto dear = [](const Json& price) {
            return price["ms"].is_object() ? price["ms"]["value"].get<double>() : 0.0;
        };
        return dear(a) > dear(b);
    });
    return prices;
}

}  // namespace foverig::sweep
