#pragma once
#include <optional>

#include "renderer/scene/imported.h"
#include "renderer/scene/tinygltf.h"

namespace foverig::scene_import {

/// Where each node of the default scene stands; nothing for nodes outside it. Throws SceneError
/// where the nodes are no forest: a cycle, or a node with two parents (30 of those can unfold to
/// 2^30).
std::vector<std::optional<dmat4>> node_transforms(const tinygltf::Model& model,
                                                  const ImportContext& context);

}  // namespace foverig::scene_import
