#pragma once
#include "renderer/scene/scene.h"

namespace foverig::scene_import {

/// Gives an imported scene what its file does not: area lights for its lamps or else one point
/// light, ambient light and sky, and a camera path. Knows good flights for a few well-known scenes.
void add_default_view(Scene& scene);

}  // namespace foverig::scene_import
