#pragma once
#include <string_view>

#include "renderer/scene/imported.h"

namespace foverig::scene_import {

/// What tinygltf does not check before it follows it: syntax, nesting depth, version, required
/// extensions, the types of the top-level arrays, every index from one object to another, and that
/// offsets, lengths and counts are whole numbers from 0. Throws SceneError naming the JSON path.
void check_gltf_json(std::string_view json, const ImportContext& context);

}  // namespace foverig::scene_import
