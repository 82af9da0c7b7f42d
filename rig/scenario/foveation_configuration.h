#pragma once
#include <string>
#include <vector>

#include "renderer/settings.h"

namespace foverig {

/// The configurations of Weier 2016 3.1 and 5, and "custom" for any other setting.
const std::vector<std::string>& foveation_configurations();

/// "custom" leaves the settings as they are.
void apply_foveation_configuration(const std::string& name, FoveationSettings& settings);

std::string foveation_configuration(const FoveationSettings& settings);

}  // namespace foverig
