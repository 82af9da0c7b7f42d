#pragma once
#include <vector>

#include "renderer/scene/occupancy.h"

namespace foverig::scene_import {

/// One point light where along a flight through rooms most space lies around it, a third of the way
/// up to whatever is above: high enough to be out of sight, low enough to shine under arches.
PointLight light_over_flight(const Scene& scene, const Occupancy& grid,
                             const std::vector<CameraKey>& keys);

/// One point light above and beside an object.
PointLight light_beside_object(const Scene& scene);

}  // namespace foverig::scene_import
