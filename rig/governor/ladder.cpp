#include "rig/governor/ladder.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <nlohmann/json.hpp>

#include "rig/failure.h"
#include "rig/scenario/parse.h"
#include "rig/scenario/write.h"

namespace foverig::governor {
namespace {

using nlohmann::json;

std::string trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\n");
    if (first == std::string_view::npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(" \t\n") - first + 1));
}

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> parts{""};
    for (const char c : text)
        if (c == at)
            parts.emplace_back();
        else
            parts.back() += c;
    return parts;
}

/// Both complete.
void check_renderer_alone(const Scenario& scenario, Scenario changed, const Rung& rung) {
    changed.render = scenario.render;
    if (scenario_toml(changed) != scenario_toml(scenario))
        throw UsageError(fmt::format(
            "governor: {}: expected settings of the renderer alone, since the rest cannot change "
            "while frames run",
            rung.text));
}

using NamedValues = std::vector<std::pair<std::string, std::string>>;

Rung rung_of(const Scenario& scenario, const NamedValues& values, double ms) {
    Scenario changed = scenario;
    Rung rung{.text = {}, .render = {}, .ms = ms, .error = std::nullopt};
    for (const auto& [name, value] : values) {
        apply_value(changed, name, value, "governor");
        rung.text += fmt::format("{}{} = {}", rung.text.empty() ? "" : ", ", name, value);
    }
    complete_scenario(changed);
    check_renderer_alone(scenario, changed, rung);
    rung.render = changed.render;
    return rung;
}

/// "MS: KEY = VALUE, ...".
Rung rung_from(const Scenario& scenario, const std::string& text) {
    const auto colon = text.find(':');
    double ms = 0.0;
    const auto [stop, error] =
        std::from_chars(text.data(), text.data() + std::min(colon, text.size()), ms);
    if (colon == std::string::npos || error != std::errc{} || stop != text.data() + colon ||
        !(ms > 0.0))
        throw UsageError(fmt::format(
            "governor.settings: \"{}\": expected \"MS: KEY = VALUE, ...\" with what it costs in "
            "milliseconds, as in \"5: foveation.p_min = 0.01; 9: foveation.p_min = 0.05\"",
            text));
    NamedValues values;
    for (const std::string& setting : split(text.substr(colon + 1), ',')) {
        const auto equals = setting.find('=');
        if (equals == std::string::npos)
            throw UsageError(
                fmt::format("governor.settings: \"{}\": expected KEY = VALUE", trimmed(setting)));
        values.emplace_back(trimmed(setting.substr(0, equals)),
                            trimmed(setting.substr(equals + 1)));
    }
    return rung_of(scenario, values, ms);
}

/// Throws json::exception where it is none.
Ladder ladder_of(const Scenario& scenario, const json& pareto) {
    Ladder ladder;
    ladder.error_name = pareto.at("error").get<std::string>();
    for (const json& place : pareto.at("front")) {
        NamedValues values;
        const json& point = pareto.at("points").at(place.at("point").get<std::size_t>());
        for (const auto& [name, value] : point.at("settings").items())
            values.emplace_back(name, value.dump());
        ladder.rungs.push_back(rung_of(scenario, values, place.at("time_ms").get<double>()));
        ladder.rungs.back().error = place.at("error").get<double>();
    }
    return ladder;
}

Ladder ladder_from_front(const Scenario& scenario) {
    const std::string& file = scenario.governor.front;
    std::ifstream stream(file);
    const json pareto = json::parse(stream, nullptr, false);
    if (!stream || !pareto.is_object() || pareto.value("schema", "") != "foverig.pareto/1")
        throw InputError(fmt::format(
            "governor.front: {}: cannot be read; expected the pareto.json of a sweep", file));
    if (pareto.contains("cases"))
        throw UsageError(fmt::format(
            "governor.front: {}: shows several scenes, whose settings are no choice between each "
            "other; expected a sweep with [knobs]",
            file));
    try {
        return ladder_of(scenario, pareto);
    } catch (const json::exception& error) {
        throw InputError(fmt::format(
            "governor.front: {}: is not as a sweep writes it ({}); expected its pareto.json as it "
            "was",
            file, error.what()));
    }
}

}  // namespace

std::optional<Ladder> read_ladder(const Scenario& asked) {
    const GovernorSettings& settings = asked.governor;
    if (settings.front.empty() && settings.settings.empty()) return std::nullopt;
    if (!settings.front.empty() && !settings.settings.empty())
        throw UsageError("governor.front and governor.settings are both given; expected one");
    Scenario scenario = asked;
    complete_scenario(scenario);
    Ladder ladder;
    if (!settings.front.empty())
        ladder = ladder_from_front(scenario);
    else
        for (const std::string& rung : split(settings.settings, ';'))
            ladder.rungs.push_back(rung_from(scenario, trimmed(rung)));
    if (ladder.rungs.empty() || ladder.rungs.size() > kMostRungs)
        throw UsageError(
            fmt::format("governor: {} settings; expected 1 to {}, since each may need a "
                        "renderer of its own",
                        ladder.rungs.size(), kMostRungs));
    std::stable_sort(ladder.rungs.begin(), ladder.rungs.end(),
                     [](const Rung& a, const Rung& b) { return a.ms < b.ms; });
    return ladder;
}

}  // namespace foverig::governor
