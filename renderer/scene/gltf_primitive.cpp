#include "renderer/scene/gltf_primitive.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

#include "renderer/scene/gltf_accessor.h"
#include "renderer/scene/import_error.h"

namespace foverig::scene_import {
namespace {

inline constexpr std::uint32_t kUnset = std::numeric_limits<std::uint32_t>::max();

std::optional<GltfAccessor> attribute(const tinygltf::Model& model,
                                      const tinygltf::Primitive& primitive, const std::string& name,
                                      int components, std::size_t count,
                                      const ImportContext& context) {
    const auto found = primitive.attributes.find(name);
    if (found == primitive.attributes.end()) return std::nullopt;
    GltfAccessor accessor(model, found->second, components, context);
    if (accessor.count() < count)
        fail(context.file, "a primitive has {} positions and {} of {}; expected as many", count,
             accessor.count(), name);
    return accessor;
}

/// Accessor elements in drawing order.
std::vector<std::uint32_t> drawn_elements(const tinygltf::Model& model,
                                          const tinygltf::Primitive& primitive,
                                          std::size_t vertex_count, const ImportContext& context) {
    std::vector<std::uint32_t> elements;
    if (primitive.indices < 0) {
        elements.resize(vertex_count);
        std::iota(elements.begin(), elements.end(), 0U);
        return elements;
    }
    const GltfAccessor indices(model, primitive.indices, 1, context);
    if (!indices.holds_indices())
        fail(context.file,
             "accessors[{}] serves as indices, but its components are not unsigned integers",
             primitive.indices);
    elements.reserve(indices.count());
    for (std::size_t i = 0; i < indices.count(); ++i) {
        elements.push_back(indices.index_at(i));
        if (elements.back() >= vertex_count)
            fail(context.file,
                 "accessors[{}] names vertex {} of {}; its indices and positions do not belong "
                 "together",
                 primitive.indices, elements.back(), vertex_count);
    }
    return elements;
}

std::vector<uvec3> triangles_of(const std::vector<std::uint32_t>& v, int mode) {
    std::vector<uvec3> triangles;
    if (v.size() < 3) return triangles;
    if (mode == TINYGLTF_MODE_TRIANGLES)
        for (std::size_t i = 0; i + 2 < v.size(); i += 3)
            triangles.emplace_back(v[i], v[i + 1], v[i + 2]);
    if (mode == TINYGLTF_MODE_TRIANGLE_STRIP)
        for (std::size_t i = 0; i + 2 < v.size(); ++i)
            triangles.emplace_back(v[i], v[i + 1 + i % 2], v[i + 2 - i % 2]);
    if (mode == TINYGLTF_MODE_TRIANGLE_FAN)
        for (std::size_t i = 1; i + 1 < v.size(); ++i) triangles.emplace_back(v[i], v[i + 1], v[0]);
    return triangles;
}

/// Renumbers the triangles' elements from 0 in the order of first use and gives those elements.
std::vector<std::uint32_t> compact(std::vector<uvec3>& triangles) {
    std::uint32_t least = kUnset;
    std::uint32_t most = 0;
    for (const uvec3& t : triangles) {
        least = std::min({least, t.x, t.y, t.z});
        most = std::max({most, t.x, t.y, t.z});
    }
    std::vector<std::uint32_t> sources;
    if (triangles.empty()) return sources;
    std::vector<std::uint32_t> number(std::size_t{most - least} + 1, kUnset);
    for (uvec3& t : triangles)
        for (int k = 0; k < 3; ++k) {
            std::uint32_t& n = number[t[k] - least];
            if (n == kUnset) {
                n = static_cast<std::uint32_t>(sources.size());
                sources.push_back(t[k]);
            }
            t[k] = n;
        }
    return sources;
}

}  // namespace

ReadPrimitive read_primitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                             GltfMaterials& materials, const ImportContext& context) {
    ReadPrimitive read;
    const auto positions_at = primitive.attributes.find("POSITION");
    const bool triangles =
        primitive.mode >= TINYGLTF_MODE_TRIANGLES && primitive.mode <= TINYGLTF_MODE_TRIANGLE_FAN;
    if (primitive.mode < 0 || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN)
        fail(context.file, "a primitive has mode {}; glTF has 0 to 6", primitive.mode);
    // glTF lets a renderer skip a primitive without positions.
    if (!triangles || positions_at == primitive.attributes.end()) return read;

    const GltfAccessor positions(model, positions_at->second, 3, context);
    read.mesh.triangles =
        triangles_of(drawn_elements(model, primitive, positions.count(), context), primitive.mode);
    if (read.mesh.triangles.size() > context.settings.max_triangles)
        fail(context.file,
             "holds more than {} triangles; raise max_triangles or take a smaller scene",
             context.settings.max_triangles);
    read.sources = compact(read.mesh.triangles);
    read.mesh.materials.assign(read.mesh.triangles.size(), materials.material(primitive.material));

    const TexcoordUse use = materials.texcoord_use(primitive.material);
    const auto normals = attribute(model, primitive, "NORMAL", 3, positions.count(), context);
    const auto texcoords = attribute(model, primitive, fmt::format("TEXCOORD_{}", use.set), 2,
                                     positions.count(), context);
    read.mesh.positions.reserve(read.sources.size());
    for (const std::uint32_t source : read.sources) {
        read.mesh.positions.push_back(positions.vec3_at(source));
        if (normals) read.mesh.normals.emplace_back(normals->vec3_at(source));
        if (texcoords)
            read.mesh.texcoords.push_back(use.offset + use.turn * texcoords->vec2_at(source));
    }
    return read;
}

}  // namespace foverig::scene_import
