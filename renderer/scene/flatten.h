#pragma once
#include "renderer/scene/imported.h"

namespace foverig::scene_import {

/// Unfolds the instances into the scene's arrays in metres: opaque triangles as one part, masked
/// ones as another. Sets origin_m where the scene is far from its file's origin, drops what has no
/// area or is not finite, and notes how much. Throws SceneError where nothing is left or a limit is
/// passed.
void flatten(ImportedScene& imported, const ImportContext& context);

}  // namespace foverig::scene_import
