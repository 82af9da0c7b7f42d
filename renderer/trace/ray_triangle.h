#pragma once
// Watertight ray-triangle intersection (Woop, Benthin and Wald 2013): in a frame whose z axis is
// the ray, three edge functions whose signs are exact for the corners as that frame rounds them.
// Neighbours round a shared corner alike, so no ray passes between them. Where the paper falls back
// to double when a sign is lost, here none is lost: products keep their rounding errors.
#include <cstdint>

#include "renderer/trace/packed_bvh.h"
#include "renderer/trace/ray.h"
#include "renderer/trace/triple.h"

namespace foverig {

/// The ray's own frame: axis kz is the largest of its direction, x and y are sheared along it.
struct ShearFrame {
    int kx = 0;
    int ky = 1;
    int kz = 2;
    vec3 origin_m{0.0F};  ///< components kx, ky, kz
    vec3 shear{0.0F};     ///< Sx, Sy, Sz of the paper

    ShearFrame() = default;
    RIG_HD explicit ShearFrame(const Ray& ray) {
        const vec3 d = glm::abs(ray.direction);
        kz = d.x > d.y ? (d.x > d.z ? 0 : 2) : (d.y > d.z ? 1 : 2);
        kx = kz == 2 ? 0 : kz + 1;
        ky = kx == 2 ? 0 : kx + 1;
        origin_m = {ray.origin_m[kx], ray.origin_m[ky], ray.origin_m[kz]};
        const float over_z = 1.0F / ray.direction[kz];
        shear = {ray.direction[kx] * over_z, ray.direction[ky] * over_z, over_z};
    }
};

/// t, and the weights of the three corners. t is NaN where the ray meets no point of the triangle.
struct TriangleHit {
    float t;
    float v;  ///< of the second corner
    float w;  ///< of the third
};

RIG_HD inline TriangleHit no_hit() {
    return {std::numeric_limits<float>::quiet_NaN(), 0.0F, 0.0F};
}

namespace detail {

/// In double, where products of floats are exact and tiny ones keep their bits.
RIG_HD inline TriangleHit precise_hit(const Triple& x, const Triple& y, const Triple& z,
                                      float scale_z) {
    const double u = double{x[2]} * double{y[1]} - double{y[2]} * double{x[1]};
    const double v = double{x[0]} * double{y[2]} - double{y[0]} * double{x[2]};
    const double w = double{x[1]} * double{y[0]} - double{y[1]} * double{x[0]};
    if ((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0)) return no_hit();
    const double sum = u + v + w;
    if (!(sum != 0.0)) return no_hit();
    const double over = 1.0 / sum;
    const double depth = (u * double{z[0]} + v * double{z[1]} + w * double{z[2]}) * over;
    return {static_cast<float>(depth * double{scale_z}), static_cast<float>(v * over),
            static_cast<float>(w * over)};
}

}  // namespace detail

RIG_INLINE TriangleHit intersect(const ShearFrame& f, const PackedTriangle& triangle) {
    const Triple z = load_triple(triangle.row[f.kz]) - f.origin_m.z;
    const Triple x = fused(-f.shear.x, z, load_triple(triangle.row[f.kx]) - f.origin_m.x);
    const Triple y = fused(-f.shear.y, z, load_triple(triangle.row[f.ky]) - f.origin_m.y);
    // Corner i's function is of the edge that it is not on.
    const Triple edge = difference_of_products(previous_corner(x), next_corner(y),
                                               previous_corner(y), next_corner(x));
    if (negative_corners(edge) != 0U && negative_corners(-edge) != 0U) return no_hit();
    const float sum = edge[0] + edge[1] + edge[2];
    constexpr float kLeast = 1.0e-24F;  // below, products may have left the range of floats
    if (!(sum >= kLeast || sum <= -kLeast)) return detail::precise_hit(x, y, z, f.shear.z);
    const float over = 1.0F / sum;
    const float v = edge[1] * over;
    const float w = edge[2] * over;
    const float depth = __builtin_fmaf(edge[0] * over, z[0], __builtin_fmaf(v, z[1], w * z[2]));
    return {depth * f.shear.z, v, w};
}

}  // namespace foverig
