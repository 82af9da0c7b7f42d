#include "rig/number_in.h"

#include <fmt/format.h>

namespace foverig {

CLI::Validator number_in(double low, double high) {
    const auto complaint = [=](std::string& text) -> std::string {
        double value = 0.0;
        if (CLI::detail::lexical_cast(text, value) && value >= low && value <= high) return {};
        return fmt::format("{} is not a number from {:g} to {:g}", text, low, high);
    };
    return {complaint, fmt::format("FLOAT in [{:g} - {:g}]", low, high), "number_in"};
}

}  // namespace foverig
