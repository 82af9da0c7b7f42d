#pragma once
// Rows of the key table for what the simulators bring: models of motion and faults.
#include <vector>

#include "rig/scenario/keys.h"

namespace foverig {

void add_motion_keys(std::vector<Key>& keys);
void add_fault_keys(std::vector<Key>& keys);

}  // namespace foverig
