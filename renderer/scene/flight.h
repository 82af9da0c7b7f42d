#pragma once
#include <optional>
#include <vector>

#include "renderer/scene/occupancy.h"

namespace foverig::scene_import {

/// A flight through the rooms of a scene at eye height, along the longest way that its free space
/// offers; nothing where that is too little.
std::optional<std::vector<CameraKey>> flight_through_rooms(const Occupancy& grid);

/// A flight from side to side along the open front of a box that is closed on all others, such as
/// Cornell's; nothing where the scene is not one.
std::optional<std::vector<CameraKey>> flight_before_stage(const Occupancy& grid,
                                                          const Bounds& bounds);

/// A round flight about an object, looking at its middle.
std::vector<CameraKey> flight_around(const Bounds& bounds);

}  // namespace foverig::scene_import
