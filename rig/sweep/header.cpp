#include "rig/sweep/header.h"

#include "rig/scenario/write.h"

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

json reference_json(const Sweep& sweep) {
    Scenario reference = sweep.base;
    reference.render = sweep.reference;
    return scenario_json(reference);
}

}  // namespace

json value_json(const KeyValue& value) {
    return std::visit([](const auto& v) { return json(v); }, value);
}

json definition_json(const Sweep& sweep) {
    json definition = {{"name", sweep.name},
                       {"scenario", scenario_json(sweep.base)},
                       {"reference", reference_json(sweep)},
                       {"knobs", knob_names(sweep)},
                       {"points", points_json(sweep)},
                       {"default_point", sweep.default_point},
                       {"repetitions", sweep.repetitions},
                       {"order", sweep.order == Order::abba ? "abba" : "random"},
                       {"seed", sweep.seed},
                       {"warm_up_frames", sweep.warm_up_frames},
                       {"error", sweep.error},
                       {"within", sweep.within},
                       {"fixed_cost", sweep.fixed_cost()}};
    if (sweep.prices) definition["price_points"] = sweep.price_points;
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
