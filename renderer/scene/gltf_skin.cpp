#include "renderer/scene/gltf_skin.h"

#include "renderer/scene/gltf_accessor.h"
#include "renderer/scene/import_error.h"

namespace foverig::scene_import {

std::vector<dmat4> joint_matrices(const tinygltf::Model& model, int index,
                                  const std::vector<std::optional<dmat4>>& node_transforms,
                                  const ImportContext& context) {
    const tinygltf::Skin& skin = model.skins.at(static_cast<std::size_t>(index));
    std::vector<dmat4> matrices;
    matrices.reserve(skin.joints.size());
    for (const int joint : skin.joints)
        matrices.push_back(node_transforms[static_cast<std::size_t>(joint)].value_or(dmat4(1.0)));
    if (skin.inverseBindMatrices < 0) return matrices;
    const GltfAccessor inverse_bind(model, skin.inverseBindMatrices, 16, context);
    if (inverse_bind.count() < matrices.size())
        fail(context.file, "skins[{}] has {} joints and {} inverse bind matrices", index,
             matrices.size(), inverse_bind.count());
    for (std::size_t j = 0; j < matrices.size(); ++j) {
        dmat4 m;
        for (int c = 0; c < 16; ++c) m[c / 4][c % 4] = inverse_bind.value(j, c);
        matrices[j] = matrices[j] * m;
    }
    return matrices;
}

bool pose(ImportedMesh& mesh, const tinygltf::Model& model, const tinygltf::Primitive& primitive,
          const std::vector<std::uint32_t>& sources, const std::vector<dmat4>& joints,
          const ImportContext& context) {
    const auto joints_at = primitive.attributes.find("JOINTS_0");
    const auto weights_at = primitive.attributes.find("WEIGHTS_0");
    if (joints_at == primitive.attributes.end() || weights_at == primitive.attributes.end())
        return false;
    const GltfAccessor joint_of(model, joints_at->second, 4, context);
    const GltfAccessor weight_of(model, weights_at->second, 4, context);
    for (std::size_t i = 0; i < sources.size(); ++i) {
        if (sources[i] >= joint_of.count() || sources[i] >= weight_of.count())
            fail(context.file, "a skinned primitive has fewer joints or weights than positions");
        dmat4 sum(0.0);
        double total = 0.0;
        for (int c = 0; c < 4; ++c) {
            const double weight = weight_of.value(sources[i], c);
            if (!(weight > 0.0)) continue;
            const double joint = joint_of.value(sources[i], c);
            if (!(joint >= 0.0 && joint < static_cast<double>(joints.size())))
                fail(context.file, "a skinned vertex names joint {} of {}", joint, joints.size());
            sum += weight * joints[static_cast<std::size_t>(joint)];
            total += weight;
        }
        if (!(total > 0.0)) continue;
        sum /= total;
        mesh.positions[i] = dvec3(sum * glm::dvec4(mesh.positions[i], 1.0));
        if (!mesh.normals.empty()) mesh.normals[i] = vec3(dmat3(sum) * dvec3(mesh.normals[i]));
    }
    return true;
}

}  // namespace foverig::scene_import
