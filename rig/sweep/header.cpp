#include "rig/sweep/header.h"

#include "rig/scenario/write.h"
#include "rig/session/recorded_origin.h"

namespace foverig::sweep {
namespace {

using nlohmann::json;

template <class T>
json or_null(const std::optional<T>& value) {
    return value ? json(*value) : json(nullptr);
}

json points_json(const Sweep& sweep) {
    json points = json::array();
    for (const Point& point : sweep.points) {
        json settings = json::object();
        for (const auto& [name, value] : point.settings) settings[name] = value_json(value);
        points.push_back(std::move(settings));
    }
    return points;
}

json knob_names(const Sweep& sweep) {
    json names = json::array();
    for (const Knob& knob : sweep.knobs) names.push_back(knob.key->name);
    return names;
}

json reference_json(const Sweep& sweep, const RenderSettings& settings) {
    Scenario reference = sweep.base;
    reference.render = settings;
    return scenario_json(reference);
}

/// [{name, note, reference}], and of each point its case's number and its variant's name.
void add_cases(const Sweep& sweep, json& definition) {
    definition["cases"] = json::array();
    for (const Case& one : sweep.cases)
        definition["cases"].push_back({{"name", one.name},
                                       {"note", one.note},
                                       {"reference", reference_json(sweep, one.reference)}});
    for (const Point& point : sweep.points) {
        definition["point_cases"].push_back(point.of_case);
        definition["point_variants"].push_back(point.variant);
    }
}

/// Of each device what a run's summary says of it: simulated, or recorded and of what.
json devices_json(const Scenario& scenario) {
    const std::string file = replayed_file(scenario);
    json devices = {{"panel", {{"origin", name_of(Origin::simulated)}}}};
    for (const char* device : {"dk2", "gaze", "camera"}) {
        if (device == std::string("camera") && !scenario.tracking.camera) continue;
        devices[device]["origin"] = name_of(file.empty() ? Origin::simulated : Origin::recorded);
        if (file.empty()) continue;
        const auto recording = Recording::open(file);
        const auto was = recording ? recorded_origin(*recording, device) : std::nullopt;
        devices[device]["recorded_from"] = was ? json(name_of(*was)) : json(nullptr);
    }
    return devices;
}

}  // namespace

json value_json(const KeyValue& value) {
    return std::visit([](const auto& v) { return json(v); }, value);
}

json definition_json(const Sweep& sweep) {
    json definition = {{"name", sweep.name},
                       {"scenario", scenario_json(sweep.base)},
                       {"devices", devices_json(sweep.base)},
                       {"reference", reference_json(sweep, sweep.reference)},
                       {"knobs", knob_names(sweep)},
                       {"points", points_json(sweep)},
                       {"default_point", or_null(sweep.default_point)},
                       {"repetitions", sweep.repetitions},
                       {"order", sweep.order == Order::abba ? "abba" : "random"},
                       {"seed", sweep.seed},
                       {"warm_up_frames", sweep.warm_up_frames},
                       {"error", sweep.error},
                       {"within", sweep.within},
                       {"fixed_cost", sweep.fixed_cost()}};
    if (sweep.prices) definition["price_points"] = sweep.price_points;
    if (!sweep.cases.empty()) add_cases(sweep, definition);
    if (sweep.errors_at_truth) definition["errors_at"] = "truth";
    if (!sweep.over.empty()) definition["over"] = sweep.over;
    if (!sweep.paper.is_null()) definition["paper"] = sweep.paper;
    if (sweep.stretches.frames > 0)
        definition["stretches"] = {{"count", sweep.stretches.count},
                                   {"frames", sweep.stretches.frames}};
    return definition;
}

json header_json(const Sweep& sweep, const BuildInfo& build, const HostInfo& host,
                 const std::string& program) {
    return {
        {"schema", "foverig.sweep/1"},
        {"sweep", definition_json(sweep)},
        {"build",
         {{"version", build.version},
          {"git", or_null(build.git)},
          {"compiler", build.compiler},
          {"flags", build.flags},
          {"type", build.build_type},
          {"fp_mode", build.fp_mode},
          {"program", program}}},
        {"host", {{"cpu", or_null(host.cpu)}, {"cores", host.cores}, {"os", or_null(host.os)}}}};
}

}  // namespace foverig::sweep
