#include "rig/scenario/foveation_configuration.h"

#include <array>

namespace foverig {
namespace {

struct Configuration {
    const char* name;
    FoveationSettings settings;
};

// "full" samples every pixel: no angle lies beyond 180 degrees.
constexpr std::array<Configuration, 4> kConfigurations{{
    {"small", {5.0, 10.0, 0.01}},
    {"medium", {10.0, 20.0, 0.05}},
    {"large", {15.0, 30.0, 0.1}},
    {"full", {180.0, 180.0, 1.0}},
}};

}  // namespace

const std::vector<std::string>& foveation_configurations() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const auto& configuration : kConfigurations) all.emplace_back(configuration.name);
        all.emplace_back("custom");
        return all;
    }();
    return names;
}

void apply_foveation_configuration(const std::string& name, FoveationSettings& settings) {
    for (const auto& configuration : kConfigurations) {
        if (name == configuration.name) settings = configuration.settings;
    }
}

std::string foveation_configuration(const FoveationSettings& settings) {
    for (const auto& [name, known] : kConfigurations) {
        if (known.r0_deg == settings.r0_deg && known.r1_deg == settings.r1_deg &&
            known.p_min == settings.p_min) {
            return name;
        }
    }
    return "custom";
}

}  // namespace foverig
