#pragma once
// Triangles in the making: what generators write into, what a Part is made from.
#include <cstdint>
#include <vector>

#include "renderer/scene/builtin/exact.h"

namespace foverig::builtin {

/// What a shape is made of and how large one repeat of its texture is.
struct Surface {
    std::uint16_t material = 0;
    float period_m = 1.0F;
};

/// Scale, then turn about +y, then shift.
struct Placement {
    vec3 position_m{0.0F};
    float turns = 0.0F;
    float scale = 1.0F;
};

struct Mesh {
    std::vector<vec3> positions_m;
    std::vector<vec3> normals;
    std::vector<vec2> texcoords;           ///< v = 0 is the top row of the texture
    std::vector<uvec3> triangles;          ///< counter-clockwise seen from where the normal points
    std::vector<std::uint16_t> materials;  ///< one per triangle

    std::uint32_t add_vertex(const vec3& position_m, const vec3& normal, const vec2& texcoord);
    /// Skipped where two corners are the same point: lathes and fans collapse at their poles.
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint16_t material);
    void append(const Mesh& other, const Placement& placement = {});
    void reserve(std::size_t vertex_count, std::size_t triangle_count);
};

}  // namespace foverig::builtin
