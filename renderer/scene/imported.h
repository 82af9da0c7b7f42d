#pragma once
// What a file's reader hands on: meshes as the file has them, and where they stand.
#include <cstdint>
#include <filesystem>
#include <vector>

#include "renderer/scene/library.h"
#include "renderer/scene/scene.h"

namespace foverig::scene_import {

using glm::dmat4;

/// Triangles in file units. Indices are in range; positions may be non-finite or degenerate.
struct ImportedMesh {
    std::vector<dvec3> positions;
    std::vector<vec3> normals;    ///< one per position (zero: unknown), or empty
    std::vector<vec2> texcoords;  ///< one per position (v = 0: top row), or empty
    std::vector<uvec3> triangles;
    std::vector<std::uint16_t> materials;  ///< one per triangle, into Scene::materials
};

struct MeshInstance {
    std::uint32_t mesh = 0;
    dmat4 world_from_mesh{1.0};
};

/// `scene` holds materials, textures and notes already; its geometry is still empty.
struct ImportedScene {
    Scene scene;
    std::vector<ImportedMesh> meshes;
    std::vector<MeshInstance> instances;
};

/// Where a reader is and what it may do.
struct ImportContext {
    std::filesystem::path file;
    ImportSettings settings;
};

/// Most materials that Scene::triangle_materials can name.
inline constexpr std::size_t kMaxMaterials = 65535;

/// Adds a material and gives its index. Throws SceneError beyond kMaxMaterials.
std::uint16_t add_material(ImportedScene& imported, const Material& material,
                           const ImportContext& context);

ImportedScene import_obj(const ImportContext& context);
ImportedScene import_gltf(const ImportContext& context);
ImportedScene import_ply(const ImportContext& context);

}  // namespace foverig::scene_import
