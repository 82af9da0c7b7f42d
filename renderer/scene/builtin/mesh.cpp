#include "renderer/scene/builtin/mesh.h"

namespace foverig::builtin {

std::uint32_t Mesh::add_vertex(const vec3& position_m, const vec3& normal, const vec2& texcoord) {
    positions_m.push_back(position_m);
    normals.push_back(normal);
    texcoords.push_back(texcoord);
    return static_cast<std::uint32_t>(positions_m.size() - 1);
}

void Mesh::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint16_t material) {
    const vec3& pa = positions_m[a];
    const vec3& pb = positions_m[b];
    const vec3& pc = positions_m[c];
    if (pa == pb || pb == pc || pc == pa) return;
    triangles.emplace_back(a, b, c);
    materials.push_back(material);
}

void Mesh::append(const Mesh& other, const Placement& placement) {
    const auto base = static_cast<std::uint32_t>(positions_m.size());
    for (std::size_t i = 0; i < other.positions_m.size(); ++i) {
        const vec3 turned = rotate_y(other.positions_m[i] * placement.scale, placement.turns);
        add_vertex(turned + placement.position_m, rotate_y(other.normals[i], placement.turns),
                   other.texcoords[i]);
    }
    for (const uvec3& t : other.triangles) triangles.push_back(t + base);
    materials.insert(materials.end(), other.materials.begin(), other.materials.end());
}

void Mesh::reserve(std::size_t vertex_count, std::size_t triangle_count) {
    positions_m.reserve(vertex_count);
    normals.reserve(vertex_count);
    texcoords.reserve(vertex_count);
    triangles.reserve(triangle_count);
    materials.reserve(triangle_count);
}

}  // namespace foverig::builtin
