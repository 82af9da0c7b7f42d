#include "renderer/scene/builtin/grid.h"

namespace foverig::builtin {

std::vector<vec3> grid_normals(const std::vector<vec3>& points, int nu, int nv, bool wrap_u) {
    std::vector<vec3> sums(points.size(), vec3{0.0F});
    const auto row = static_cast<std::size_t>(nu + 1);
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
        const vec3 area = cross(points[b] - points[a], points[c] - points[a]);
        sums[a] += area;
        sums[b] += area;
        sums[c] += area;
    };
    for (std::size_t j = 0; j < static_cast<std::size_t>(nv); ++j) {
        for (std::size_t i = 0; i + 1 < row; ++i) {
            const std::size_t a = j * row + i;
            add(a, a + 1, a + row + 1);
            add(a, a + row + 1, a + row);
        }
    }
    for (std::size_t j = 0; wrap_u && j <= static_cast<std::size_t>(nv); ++j) {
        const vec3 both = sums[j * row] + sums[j * row + row - 1];
        sums[j * row] = both;
        sums[j * row + row - 1] = both;
    }
    for (vec3& n : sums) n = n == vec3{0.0F} ? vec3{0.0F, 1.0F, 0.0F} : normalize(n);
    return sums;
}

}  // namespace foverig::builtin
