#pragma once
#include <vector>

#include "rig/scenario/keys.h"

namespace foverig {

void add_see_through_keys(std::vector<Key>& keys);

}  // namespace foverig
