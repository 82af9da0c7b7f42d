#pragma once
#include <vector>

#include "renderer/scene/builtin/mesh.h"

namespace foverig::builtin {

/// Smooth patch of nu x nv cells: point(u, v) -> position and texcoord(u, v), u and v in [0, 1].
/// Faces cross(dp/du, dp/dv). `wrap_u` says that u = 1 is u = 0, so that the seam is smooth too.
template <class Point, class Texcoord>
void add_grid(Mesh& mesh, std::uint16_t material, int nu, int nv, bool wrap_u, Point&& point,
              Texcoord&& texcoord);

/// Unit normals of a grid of (nu + 1) x (nv + 1) points, from the triangles around each.
std::vector<vec3> grid_normals(const std::vector<vec3>& points, int nu, int nv, bool wrap_u);

template <class Point, class Texcoord>
void add_grid(Mesh& mesh, std::uint16_t material, int nu, int nv, bool wrap_u, Point&& point,
              Texcoord&& texcoord) {
    const auto base = static_cast<std::uint32_t>(mesh.positions_m.size());
    std::vector<vec3> points;
    points.reserve(static_cast<std::size_t>((nu + 1) * (nv + 1)));
    for (int j = 0; j <= nv; ++j) {
        for (int i = 0; i <= nu; ++i) {
            const int iu = wrap_u && i == nu ? 0 : i;
            points.push_back(point(static_cast<float>(iu) / static_cast<float>(nu),
                                   static_cast<float>(j) / static_cast<float>(nv)));
        }
    }
    const std::vector<vec3> normals = grid_normals(points, nu, nv, wrap_u);
    std::size_t n = 0;
    for (int j = 0; j <= nv; ++j) {
        for (int i = 0; i <= nu; ++i, ++n) {
            mesh.add_vertex(points[n], normals[n],
                            texcoord(static_cast<float>(i) / static_cast<float>(nu),
                                     static_cast<float>(j) / static_cast<float>(nv)));
        }
    }
    const auto row = static_cast<std::uint32_t>(nu + 1);
    for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(nv); ++j) {
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
            const std::uint32_t a = base + j * row + i;
            mesh.add_triangle(a, a + 1, a + row + 1, material);
            mesh.add_triangle(a, a + row + 1, a + row, material);
        }
    }
}

}  // namespace foverig::builtin
