#pragma once
#include <vector>

#include "rig/scenario/keys.h"

namespace foverig {

void add_window_keys(std::vector<Key>& keys);

}  // namespace foverig
