#pragma once
// Rows of the key table that fill RenderSettings.
#include <vector>

#include "rig/scenario/keys.h"

namespace foverig {

void add_renderer_keys(std::vector<Key>& keys);
void add_foveation_keys(std::vector<Key>& keys);
void add_lighting_keys(std::vector<Key>& keys);
void add_reprojection_keys(std::vector<Key>& keys);
void add_reference_keys(std::vector<Key>& keys);
void add_effect_keys(std::vector<Key>& keys);

}  // namespace foverig
