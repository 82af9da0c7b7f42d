#pragma once
#include "renderer/scene/scene.h"

namespace foverig::scene_import {

/// Adds an AreaLight for each flat patch of emissive triangles (the scene's own lamps): a
/// parallelogram where the patch is one, else the rectangle around it with the radiance thinned out
/// to the same power. At most 8, the strongest. Curved and textured patches stay mere surfaces.
/// Adds none and gives 0 where all of them together would leave the scene dark.
std::size_t add_lights_from_emission(Scene& scene);

}  // namespace foverig::scene_import
