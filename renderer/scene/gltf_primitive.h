#pragma once
#include "renderer/scene/gltf_materials.h"
#include "renderer/scene/imported.h"
#include "renderer/scene/tinygltf.h"

namespace foverig::scene_import {

struct ReadPrimitive {
    ImportedMesh mesh;
    std::vector<std::uint32_t> sources;  ///< the accessor element each vertex was read from
};

/// One primitive as triangles; lists, strips and fans. Empty for points and lines. Only the
/// vertices that its indices name are read: many primitives may share one long accessor.
ReadPrimitive read_primitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                             GltfMaterials& materials, const ImportContext& context);

}  // namespace foverig::scene_import
