#include "rig/scenario/simulation_keys.h"

#include "rig/scenario/key_makers.h"
#include "simulators/motion/catalog.h"

namespace foverig {
namespace {

/// A model's name or a trajectory's file; the file is opened when the run starts.
template <class Access>
Key motion_key(std::string name, std::span<const motion::MotionInfo> models,
               std::vector<std::string> names, std::string help, Access at) {
    for (const auto& model : models) names.emplace_back(model.name);
    Key key = text_key(std::move(name), "one of " + joined(names) + ", or a file.csv",
                       std::move(help), at);
    key.set = [at, names, expected = key.expected](
                  Scenario& s, const KeyValue& v) -> std::optional<std::string> {
        const auto& value = std::get<std::string>(v);
        const bool is_model = std::find(names.begin(), names.end(), value) != names.end();
        if (!is_model && !value.ends_with(".csv")) return expected;
        at(s) = value;
        return std::nullopt;
    };
    return key;
}

Key fault_key(const FaultInfo& fault) {
    const std::string device(fault.device);
    const std::string kind(fault.kind);
    const auto field = fault.field;
    const auto strength = [field](const Scenario& s) {
        FaultSettings copy = s.faults;
        return field(copy);
    };
    return {.name = "faults." + device + "." + kind,
            .type = KeyType::number,
            .expected = "a number" + range_text({fault.low, fault.high}, std::string(fault.unit)) +
                        fmt::format("; typical {}", fault.typical),
            .help = std::string(fault.meaning),
            .get = [strength](const Scenario& s) { return KeyValue(strength(s)); },
            .set = [device, kind](Scenario& s, const KeyValue& v) -> std::optional<std::string> {
                const auto status = set_fault(s.faults, device, kind, std::get<double>(v));
                return status ? std::nullopt : std::optional(status.error().text);
            },
            .present = [strength](const Scenario& s) { return strength(s) != 0.0; }};
}

}  // namespace

void add_motion_keys(std::vector<Key>& keys) {
    keys.push_back(motion_key(
        "motion.head", motion::head_motions(), {}, "how the head moves",
        [](auto& s) -> auto& { return s.motion.head; }));
    keys.push_back(motion_key(
        "motion.gaze", motion::eye_motions(), {kMouseGaze},
        "how the eyes move in the head; mouse: they follow the cursor of a window",
        [](auto& s) -> auto& { return s.motion.gaze; }));
}

void add_fault_keys(std::vector<Key>& keys) {
    for (const FaultInfo& fault : known_faults()) keys.push_back(fault_key(fault));
}

}  // namespace foverig
