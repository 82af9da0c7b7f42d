#pragma once
#include <optional>
#include <vector>

#include "renderer/scene/scene.h"

namespace foverig::scene_import {

/// A flight picked by hand for a well-known scene, whatever its file's name and unit: recognised by
/// the proportions of its bounds, to half a percent. Nothing for others.
std::optional<std::vector<CameraKey>> known_flight(const Scene& scene);

}  // namespace foverig::scene_import
