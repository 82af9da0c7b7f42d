#pragma once
#include <vector>

#include "rig/scenario/keys.h"

namespace foverig {

/// hardware.* and tracking.*
void add_hardware_keys(std::vector<Key>& keys);

}  // namespace foverig
