#pragma once
#include "renderer/scene/imported.h"
#include "renderer/scene/tinygltf.h"

namespace foverig::scene_import {

/// Parses a .gltf or .glb file and its buffers (embedded, data URI, or a file in the scene's
/// folder). Images stay encoded. Every index between its objects is in range; byte ranges are not
/// yet checked.
tinygltf::Model read_gltf(const ImportContext& context);

}  // namespace foverig::scene_import
