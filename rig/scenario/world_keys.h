#pragma once
// Rows of the key table that say where a person stands in the scene and what lights are added to
// it.
#include <vector>

#include "rig/scenario/keys.h"

namespace foverig {

void add_camera_keys(std::vector<Key>& keys);
void add_light_keys(std::vector<Key>& keys);

}  // namespace foverig
