#pragma once
#include <nlohmann/json.hpp>
#include <string_view>

#include "renderer/scene/imported.h"

namespace foverig::scene_import {

/// The JSON text of a GLB file. Throws SceneError where its header or first chunk is wrong.
std::string_view glb_json(std::string_view bytes, const ImportContext& context);

/// Throws SceneError where the text is not JSON, or nests deeper than 64 levels.
nlohmann::json parse_json(std::string_view text, const ImportContext& context);

}  // namespace foverig::scene_import
