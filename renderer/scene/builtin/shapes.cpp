#include "renderer/scene/builtin/shapes.h"

#include <algorithm>

#include "renderer/scene/builtin/grid.h"
#include "renderer/scene/builtin/noise.h"

namespace foverig::builtin {

vec2 box_mapped(const vec3& p, const vec3& normal, float period_m) {
    const vec3 size{std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)};
    if (size.y >= size.x && size.y >= size.z) return vec2{p.x, p.z} / period_m;
    return vec2{size.x > size.z ? p.z : p.x, -p.y} / period_m;
}

void add_quad(Mesh& mesh, Surface surface, const vec3& corner_m, const vec3& edge_u_m,
              const vec3& edge_v_m) {
    const vec3 normal = normalize(cross(edge_u_m, edge_v_m));
    const auto vertex = [&](const vec3& p) {
        return mesh.add_vertex(p, normal, box_mapped(p, normal, surface.period_m));
    };
    const std::uint32_t a = vertex(corner_m);
    const std::uint32_t b = vertex(corner_m + edge_u_m);
    const std::uint32_t c = vertex(corner_m + edge_u_m + edge_v_m);
    const std::uint32_t d = vertex(corner_m + edge_v_m);
    mesh.add_triangle(a, b, c, surface.material);
    mesh.add_triangle(a, c, d, surface.material);
}

void add_card(Mesh& mesh, std::uint16_t material, const vec3& corner_m, const vec3& edge_u_m,
              const vec3& edge_v_m, vec2 top_left, vec2 bottom_right) {
    const vec3 normal = normalize(cross(edge_u_m, edge_v_m));
    const std::uint32_t a = mesh.add_vertex(corner_m, normal, {top_left.x, bottom_right.y});
    const std::uint32_t b = mesh.add_vertex(corner_m + edge_u_m, normal, bottom_right);
    const std::uint32_t c =
        mesh.add_vertex(corner_m + edge_u_m + edge_v_m, normal, {bottom_right.x, top_left.y});
    const std::uint32_t d = mesh.add_vertex(corner_m + edge_v_m, normal, top_left);
    mesh.add_triangle(a, b, c, material);
    mesh.add_triangle(a, c, d, material);
}

void add_box(Mesh& mesh, Surface surface, const vec3& min_m, const vec3& max_m, unsigned faces) {
    const vec3 size = max_m - min_m;
    const vec3 x{size.x, 0.0F, 0.0F};
    const vec3 y{0.0F, size.y, 0.0F};
    const vec3 z{0.0F, 0.0F, size.z};
    if ((faces & kLeft) != 0U) add_quad(mesh, surface, min_m, z, y);
    if ((faces & kRight) != 0U) add_quad(mesh, surface, max_m - y, -z, y);
    if ((faces & kBottom) != 0U) add_quad(mesh, surface, min_m, x, z);
    if ((faces & kTop) != 0U) add_quad(mesh, surface, max_m - x, x, -z);
    if ((faces & kBack) != 0U) add_quad(mesh, surface, min_m + x, -x, y);
    if ((faces & kFront) != 0U) add_quad(mesh, surface, min_m + z, x, y);
}

void add_lathe(Mesh& mesh, Surface surface, std::span<const vec2> profile_m, int segments,
               const vec3& centre_m) {
    const std::size_t strip_count = profile_m.size() - 1;
    std::vector<vec2> facing(strip_count);
    float widest_m = 0.0F;
    for (std::size_t i = 0; i < strip_count; ++i) {
        const vec2 along = profile_m[i + 1] - profile_m[i];
        facing[i] = vec2{along.y, -along.x} / length(along);
        widest_m = std::max({widest_m, profile_m[i].x, profile_m[i + 1].x});
    }
    const auto smooth = [&](std::size_t strip, std::size_t other) {
        const vec2 a = facing[strip];
        if (other >= strip_count) return a;
        const vec2 b = facing[other];
        const bool crease = a.x * b.x + a.y * b.y < 0.64F;
        return crease ? a : (a + b) / length(a + b);
    };
    const float repeats =
        std::max(1.0F, std::floor(6.2831853F * widest_m / surface.period_m + 0.5F));
    float along_m = 0.0F;
    for (std::size_t i = 0; i < strip_count; ++i) {
        const vec2 low = profile_m[i];
        const vec2 high = profile_m[i + 1];
        const vec2 low_normal = smooth(i, i - 1);
        const vec2 high_normal = smooth(i, i + 1);
        const float next_m = along_m + length(high - low);
        const auto base = static_cast<std::uint32_t>(mesh.positions_m.size());
        for (int s = 0; s <= segments; ++s) {
            const float turns = static_cast<float>(s) / static_cast<float>(segments);
            const float c = cosine(turns);
            const float z = -sine(turns);
            const auto ring = [&](vec2 p, vec2 n, float v) {
                mesh.add_vertex(centre_m + vec3{p.x * c, p.y, p.x * z}, vec3{n.x * c, n.y, n.x * z},
                                {turns * repeats, -v / surface.period_m});
            };
            ring(low, low_normal, along_m);
            ring(high, high_normal, next_m);
        }
        for (std::uint32_t s = 0; s < static_cast<std::uint32_t>(segments); ++s) {
            const std::uint32_t a = base + 2 * s;
            mesh.add_triangle(a, a + 2, a + 3, surface.material);
            mesh.add_triangle(a, a + 3, a + 1, surface.material);
        }
        along_m = next_m;
    }
}

void add_prism(Mesh& mesh, Surface surface, std::span<const vec2> outline_m, float z0_m,
               float z1_m) {
    const std::size_t n = outline_m.size();
    for (std::size_t i = 0; i < n; ++i) {
        const vec2 a = outline_m[i];
        const vec2 b = outline_m[(i + 1) % n];
        add_quad(mesh, surface, {a.x, a.y, z1_m}, {0.0F, 0.0F, z0_m - z1_m},
                 {b.x - a.x, b.y - a.y, 0.0F});
    }
    const auto cap = [&](float z_m, bool front) {
        const vec3 normal{0.0F, 0.0F, front ? 1.0F : -1.0F};
        const auto base = static_cast<std::uint32_t>(mesh.positions_m.size());
        for (const vec2& p : outline_m) {
            mesh.add_vertex({p.x, p.y, z_m}, normal,
                            box_mapped({p.x, p.y, z_m}, normal, surface.period_m));
        }
        for (std::uint32_t i = 1; i + 1 < n; ++i) {
            mesh.add_triangle(base, base + (front ? i : i + 1), base + (front ? i + 1 : i),
                              surface.material);
        }
    };
    cap(z1_m, true);
    cap(z0_m, false);
}

void add_blob(Mesh& mesh, Surface surface, const vec3& centre_m, const vec3& radii_m, int segments,
              float bumps, std::uint32_t seed) {
    const auto point = [&](float u, float v) {
        const float ring = sine(v * 0.5F);
        const vec3 direction{ring * cosine(u), -cosine(v * 0.5F), -ring * sine(u)};
        const float grown =
            bumps == 0.0F ? 1.0F : 1.0F + bumps * fractal_noise(direction * 2.0F, 3, seed);
        return centre_m + radii_m * direction * grown;
    };
    const float widest_m = std::max(radii_m.x, radii_m.z);
    const float repeats =
        std::max(1.0F, std::floor(6.2831853F * widest_m / surface.period_m + 0.5F));
    add_grid(mesh, surface.material, segments, segments / 2, true, point, [&](float u, float v) {
        return vec2{u * repeats, -v * repeats * 0.5F};
    });
}

}  // namespace foverig::builtin
