#pragma once
#include <optional>

#include "renderer/scene/imported.h"
#include "renderer/scene/tinygltf.h"

namespace foverig::scene_import {

/// World transforms of a skin's joints, each after its inverse bind matrix.
std::vector<dmat4> joint_matrices(const tinygltf::Model& model, int skin,
                                  const std::vector<std::optional<dmat4>>& node_transforms,
                                  const ImportContext& context);

/// Moves the vertices of one primitive to where its joints hold them; `sources[i]` is the accessor
/// element that vertex i was read from. False where the primitive has no joints.
bool pose(ImportedMesh& mesh, const tinygltf::Model& model, const tinygltf::Primitive& primitive,
          const std::vector<std::uint32_t>& sources, const std::vector<dmat4>& joints,
          const ImportContext& context);

}  // namespace foverig::scene_import
