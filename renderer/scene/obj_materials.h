#pragma once
#include <map>
#include <string>

#include "renderer/scene/imported.h"
#include "renderer/scene/scene_folder.h"
#include "renderer/scene/tinyobj.h"

namespace foverig::scene_import {

/// The materials of an OBJ file's libraries; those that faces use become Scene materials.
class ObjMaterials : public tinyobj::MaterialReader {
  public:
    ObjMaterials(ImportedScene& imported, const ImportContext& context)
        : imported_(imported), context_(context), folder_(context.file) {}

    /// tinyobjloader's question for a library. One that is missing or outside the folder is noted,
    /// and its materials become the default one.
    bool operator()(const std::string& library, std::vector<tinyobj::material_t>* materials,
                    std::map<std::string, int>* index_of, std::string* warning,
                    std::string* error) override;

    /// The Scene material for a name after `usemtl` ("" before the first).
    std::uint16_t material(const std::string& name);

  private:
    Material converted(const tinyobj::material_t& mtl);
    std::int32_t texture(const std::string& colour, const std::string& mask, bool clamp);

    ImportedScene& imported_;
    const ImportContext& context_;
    SceneFolder folder_;
    std::map<std::string, tinyobj::material_t> known_;
    std::map<std::string, std::uint16_t> used_;
    std::map<std::string, std::int32_t> textures_;
};

}  // namespace foverig::scene_import
