#include "renderer/scene/gltf_nodes.h"

#include "renderer/scene/import_error.h"

namespace foverig::scene_import {
namespace {

dmat4 local_transform(const tinygltf::Node& node) {
    dmat4 matrix(1.0);
    if (node.matrix.size() == 16) {
        for (int i = 0; i < 16; ++i)
            matrix[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
        return matrix;
    }
    if (node.rotation.size() == 4) {
        const dquat q(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
        const double length = glm::length(q);
        if (length > 0.0) matrix = glm::mat4_cast(q / length);
    }
    if (node.scale.size() == 3)
        for (int k = 0; k < 3; ++k) matrix[k] *= node.scale[static_cast<std::size_t>(k)];
    if (node.translation.size() == 3)
        for (int k = 0; k < 3; ++k) matrix[3][k] = node.translation[static_cast<std::size_t>(k)];
    return matrix;
}

/// The default scene's nodes; of a file without scenes, all nodes that are nobody's child.
std::vector<int> roots(const tinygltf::Model& model, const std::vector<int>& parent) {
    if (!model.scenes.empty())
        return model
            .scenes[model.defaultScene > 0 ? static_cast<std::size_t>(model.defaultScene) : 0]
            .nodes;
    std::vector<int> result;
    for (std::size_t i = 0; i < parent.size(); ++i)
        if (parent[i] < 0) result.push_back(static_cast<int>(i));
    return result;
}

std::vector<int> parents(const tinygltf::Model& model, const ImportContext& context) {
    std::vector<int> parent(model.nodes.size(), -1);
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
        for (const int child : model.nodes[i].children) {
            int& of_child = parent[static_cast<std::size_t>(child)];
            if (of_child >= 0)
                fail(context.file,
                     "nodes[{}] is a child of nodes[{}] and of nodes[{}]; glTF nodes form a tree",
                     child, of_child, i);
            of_child = static_cast<int>(i);
        }
    return parent;
}

}  // namespace

std::vector<std::optional<dmat4>> node_transforms(const tinygltf::Model& model,
                                                  const ImportContext& context) {
    const std::vector<int> parent = parents(model, context);
    std::vector<std::optional<dmat4>> transforms(model.nodes.size());
    // A stack of our own: a chain may be 50,000 nodes deep.
    std::vector<std::pair<int, dmat4>> open;
    for (const int root : roots(model, parent)) open.emplace_back(root, dmat4(1.0));
    std::size_t visits = 0;
    while (!open.empty()) {
        const auto [index, above] = open.back();
        open.pop_back();
        // Each node has one parent, so only a scene's list can name one again; a cycle never ends.
        if (++visits > 2 * model.nodes.size())
            fail(context.file, "nodes[{}] is its own descendant; glTF nodes form a tree", index);
        const tinygltf::Node& node = model.nodes[static_cast<std::size_t>(index)];
        const dmat4 world = above * local_transform(node);
        // A scene that lists a child as a root too would draw it twice; it stays below its parent.
        if (parent[static_cast<std::size_t>(index)] < 0 ||
            !transforms[static_cast<std::size_t>(index)])
            transforms[static_cast<std::size_t>(index)] = world;
        for (const int child : node.children) open.emplace_back(child, world);
    }
    return transforms;
}

}  // namespace foverig::scene_import
