#include "renderer/scene/imported.h"

#include "renderer/scene/import_error.h"

namespace foverig::scene_import {

std::uint16_t add_material(ImportedScene& imported, const Material& material,
                           const ImportContext& context) {
    std::vector<Material>& materials = imported.scene.materials;
    if (materials.size() >= kMaxMaterials)
        fail(context.file, "uses more than {} materials; merge those that are alike",
             kMaxMaterials);
    materials.push_back(material);
    return static_cast<std::uint16_t>(materials.size() - 1);
}

}  // namespace foverig::scene_import
