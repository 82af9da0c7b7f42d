#pragma once
#include <map>

#include "renderer/scene/imported.h"
#include "renderer/scene/scene_folder.h"
#include "renderer/scene/tinygltf.h"

namespace foverig::scene_import {

/// Which texture coordinates a material's textures want: attribute TEXCOORD_<set>, then
/// uv' = offset + turn * uv (KHR_texture_transform).
struct TexcoordUse {
    int set = 0;
    vec2 offset{0.0F};
    glm::mat2 turn{1.0F};
};

/// glTF's metallic-roughness materials as Phong ones, made when a primitive first asks for them.
///
/// base colour c, metalness m, roughness r: specular = mix(0.04, c, m) (1 - r)^2, exponent 2/r^4 -
/// 2 (the Phong lobe as wide as the GGX one), reflectance = the metal's share of that. A metal
/// keeps half its colour as diffuse light: with no mirror rays it would be black. Opaque alpha,
/// masks and blends become an alpha cutoff, glass a transmission; a pipeline that traces these rays
/// mixes them over the Phong colour.
class GltfMaterials {
  public:
    GltfMaterials(ImportedScene& imported, const tinygltf::Model& model,
                  const ImportContext& context)
        : imported_(imported), model_(model), context_(context), folder_(context.file) {}

    /// The Scene material for a glTF one (-1: the default).
    std::uint16_t material(int index);
    TexcoordUse texcoord_use(int index) const;

  private:
    Material converted(const tinygltf::Material& gltf);
    std::int32_t texture(const tinygltf::TextureInfo& info, bool alpha);
    std::int32_t texture(int index, bool alpha);
    std::string encoded_image(int index) const;

    ImportedScene& imported_;
    const tinygltf::Model& model_;
    const ImportContext& context_;
    SceneFolder folder_;
    std::map<int, std::uint16_t> used_;
    std::map<std::pair<int, bool>, std::int32_t>
        textures_;  ///< by texture and whether its alpha counts
};

}  // namespace foverig::scene_import
