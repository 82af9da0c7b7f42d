#include <set>

#include "renderer/scene/gltf_file.h"
#include "renderer/scene/gltf_nodes.h"
#include "renderer/scene/gltf_primitive.h"
#include "renderer/scene/gltf_skin.h"
#include "renderer/scene/import_error.h"

namespace foverig::scene_import {
namespace {

/// Comic outlines are a dark copy of the mesh, inflated and inside out, that back-face culling
/// turns into a rim. Rays see both sides: to them it is a black bag over everything.
bool is_outline(const tinygltf::Model& model, const tinygltf::Primitive& primitive) {
    if (primitive.material < 0) return false;
    const tinygltf::Material& material =
        model.materials[static_cast<std::size_t>(primitive.material)];
    return !material.doubleSided && (material.name.find("outline") != std::string::npos ||
                                     material.name.find("Outline") != std::string::npos);
}

class GltfImporter {
  public:
    GltfImporter(const tinygltf::Model& model, const ImportContext& context)
        : model_(model),
          context_(context),
          materials_(imported_, model, context),
          transforms_(node_transforms(model, context)),
          meshes_(model.meshes.size()) {}

    ImportedScene run() {
        for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
            const tinygltf::Node& node = model_.nodes[i];
            if (!transforms_[i] || node.mesh < 0) continue;
            if (node.skin >= 0)
                add_skinned(node);
            else
                add_instances(node.mesh, *transforms_[i]);
        }
        if (imported_.instances.empty())
            fail(context_.file,
                 "shows nothing: no node of its scene has a mesh of triangles with positions");
        note_left_out();
        return std::move(imported_);
    }

  private:
    /// The primitives of a mesh are read once, however many nodes show it.
    void add_instances(int mesh, const dmat4& world) {
        std::optional<std::vector<std::uint32_t>>& indices =
            meshes_[static_cast<std::size_t>(mesh)];
        if (!indices) {
            indices.emplace();
            for (const tinygltf::Primitive& primitive :
                 model_.meshes[static_cast<std::size_t>(mesh)].primitives) {
                if (!is_wanted(primitive)) continue;
                ReadPrimitive read = read_primitive(model_, primitive, materials_, context_);
                if (!read.mesh.triangles.empty())
                    indices->push_back(add_mesh(std::move(read.mesh)));
            }
        }
        for (const std::uint32_t index : *indices) imported_.instances.push_back({index, world});
    }

    /// A skinned mesh stands where its joints are; its node's own transform does not count
    /// (glTF 3.7.3.3).
    void add_skinned(const tinygltf::Node& node) {
        const std::vector<dmat4> joints = joint_matrices(model_, node.skin, transforms_, context_);
        for (const tinygltf::Primitive& primitive :
             model_.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
            if (!is_wanted(primitive)) continue;
            ReadPrimitive read = read_primitive(model_, primitive, materials_, context_);
            if (read.mesh.triangles.empty()) continue;
            pose(read.mesh, model_, primitive, read.sources, joints, context_);
            imported_.instances.push_back({add_mesh(std::move(read.mesh)), dmat4(1.0)});
        }
    }

    std::uint32_t add_mesh(ImportedMesh mesh) {
        imported_.meshes.push_back(std::move(mesh));
        return static_cast<std::uint32_t>(imported_.meshes.size() - 1);
    }

    bool is_wanted(const tinygltf::Primitive& primitive) {
        has_targets_ = has_targets_ || !primitive.targets.empty();
        const bool outline = is_outline(model_, primitive);
        const bool thin = primitive.mode < TINYGLTF_MODE_TRIANGLES;
        outlines_ += outline ? 1 : 0;
        lines_and_points_ += thin ? 1 : 0;
        return !outline && !thin;
    }

    void note_left_out() {
        std::vector<std::string>& notes = imported_.scene.notes;
        if (lines_and_points_ > 0)
            notes.push_back(
                fmt::format("{} primitives of points or lines left out", lines_and_points_));
        if (outlines_ > 0)
            notes.push_back(fmt::format("{} primitives of comic outlines left out", outlines_));
        if (has_targets_)
            notes.emplace_back("morph targets left out: meshes keep their base shape");
        if (!model_.animations.empty())
            notes.emplace_back(
                "animations left out: everything stands as in the file's first pose");
    }

    const tinygltf::Model& model_;
    const ImportContext& context_;
    ImportedScene imported_;
    GltfMaterials materials_;
    std::vector<std::optional<dmat4>> transforms_;
    std::vector<std::optional<std::vector<std::uint32_t>>> meshes_;  ///< by glTF mesh: ours
    std::size_t lines_and_points_ = 0;
    std::size_t outlines_ = 0;
    bool has_targets_ = false;
};

}  // namespace

ImportedScene import_gltf(const ImportContext& context) {
    const tinygltf::Model model = read_gltf(context);
    return GltfImporter(model, context).run();
}

}  // namespace foverig::scene_import
