#pragma once
// Whether two tracers that answer one ray differently are both right, told in double precision.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "renderer/kernels/alpha_test.h"
#include "renderer/trace/ray.h"

namespace foverig::bench {

/// How two answers to one ray compare. All but `wrong` are agreement or a tie of a known kind.
enum class Verdict {
    same,       ///< one triangle, or both missed
    tie,        ///< two triangles, t within 4 ulps
    exact_tie,  ///< ... by their exact t; the tracers' own are rounded further apart
    edge,       ///< the ray passes an edge of the nearer triangle by less than rounding
    grazing,    ///< the ray is so flat on the nearer triangle that rounding moves its t as far
    range,      ///< the nearer t is within rounding of the end of the ray's range
    texel,      ///< the nearer hit lies on the border of an alpha mask's texel
    peer,       ///< Embree's own rounding, see compare; ours is right in double
    wrong
};
inline constexpr std::array kVerdictNames{"same",  "tie",   "exact_tie", "edge", "grazing",
                                          "range", "texel", "peer",      "wrong"};
using Verdicts = std::array<std::uint64_t, kVerdictNames.size()>;

/// Steps of float between two numbers of one sign.
inline std::uint32_t ulps_between(float a, float b) {
    const auto order = [](float x) { return std::bit_cast<std::int32_t>(x + 0.0F); };
    return static_cast<std::uint32_t>(std::abs(std::int64_t{order(a)} - order(b)));
}

/// A triangle's plane and edges as a ray meets them, in double.
class ExactHit {
  public:
    ExactHit(const SceneView& scene, const Ray& ray, std::uint32_t triangle)
        : o_(ray.origin_m), d_(ray.direction) {
        const uvec3 c = scene.triangles[triangle];
        corner_ = {dvec3(scene.positions_m[c.x]), dvec3(scene.positions_m[c.y]),
                   dvec3(scene.positions_m[c.z])};
        const dvec3 normal = glm::cross(corner_[1] - corner_[0], corner_[2] - corner_[0]);
        const double slope = glm::dot(normal, d_);
        t = glm::dot(normal, corner_[0] - o_) / slope;
        flatness = glm::length(normal) / std::abs(slope);
        span = std::abs(slope);
        slip = std::max(1.0, flatness * glm::length(d_));
        double longest_m = 0.0;
        for (std::size_t i = 0; i < 3; ++i)
            longest_m = std::max(longest_m, glm::length(corner_[(i + 1) % 3] - corner_[i]));
        height_m = glm::length(normal) / longest_m;
        const dvec3 p = o_ + t * d_;
        const double twice_area = glm::dot(normal, normal);
        u = glm::dot(glm::cross(corner_[2] - corner_[0], corner_[0] - p), normal) / twice_area;
        v = glm::dot(glm::cross(corner_[0] - corner_[1], corner_[0] - p), normal) / twice_area;
        for (const dvec3& corner : corner_)
            reach_m = std::max({reach_m, std::abs(corner.x - o_.x), std::abs(corner.y - o_.y),
                                std::abs(corner.z - o_.z)});
    }

    /// Distance of the ray's line to the nearest edge.
    double edge_distance_m() const {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < 3; ++i) {
            const dvec3 edge = corner_[(i + 1) % 3] - corner_[i];
            const dvec3 across = glm::cross(d_, edge);
            const double length = glm::length(across);
            const dvec3 to = corner_[i] - o_;
            // Of an edge along the ray the distance is that of two parallels.
            const double distance = length > 1.0e-12 * glm::length(d_) * glm::length(edge)
                                        ? std::abs(glm::dot(across, to)) / length
                                        : glm::length(glm::cross(d_, to)) / glm::length(d_);
            least = std::min(least, std::isnan(distance) ? 0.0 : distance);
        }
        return least;
    }

    double t;
    double flatness;  ///< a move of the plane by x moves t by flatness * x
    double span;      ///< twice the area as the ray sees it, times the ray's length
    double slip;      ///< ... and the point along the triangle by slip * x
    double height_m;  ///< least of the three
    double u;
    double v;
    double reach_m = 0.0;  ///< largest coordinate difference of ray origin and corner

  private:
    dvec3 o_;
    dvec3 d_;
    std::array<dvec3, 3> corner_;
};

/// Rounding of either tracer: 2^-20 of the distances involved, as renderer/trace/slab_frame.h.
inline constexpr double kRounding = 9.5367431640625e-7;

/// Whether rounding of the hit point could turn a texel into its neighbour.
inline bool on_texel_border(const SceneView& scene, std::uint32_t triangle, const ExactHit& hit) {
    const Material& material = scene.materials[scene.triangle_materials[triangle]];
    if (material.alpha_cutoff <= 0.0F || scene.texcoords.empty()) return false;
    const double spread = kRounding * hit.reach_m * hit.slip / hit.height_m;
    bool any_hole = false;
    bool any_solid = false;
    for (const double du : {-spread, 0.0, spread}) {
        for (const double dv : {-spread, 0.0, spread}) {
            const bool hole = is_hole(scene, triangle, static_cast<float>(hit.u + du),
                                      static_cast<float>(hit.v + dv));
            (hole ? any_hole : any_solid) = true;
        }
    }
    return any_hole && any_solid;
}

/// Whether the ray meets solid matter of the triangle, by exact weights.
inline bool meets_matter(const SceneView& scene, std::uint32_t triangle, const ExactHit& hit) {
    const Material& material = scene.materials[scene.triangle_materials[triangle]];
    const bool inside = hit.u >= 0.0 && hit.v >= 0.0 && hit.u + hit.v <= 1.0;
    const bool hole =
        material.alpha_cutoff > 0.0F && !scene.texcoords.empty() &&
        is_hole(scene, triangle, static_cast<float>(hit.u), static_cast<float>(hit.v));
    return inside && !hole;
}

inline Verdict compare(const SceneView& scene, const Ray& ray, const Hit& embree, const Hit& ours) {
    const auto rounding_t = [&](const ExactHit& h) { return kRounding * h.reach_m * h.flatness; };
    if (embree.triangle == ours.triangle) {
        if (ours.missed() || ulps_between(embree.t, ours.t) <= 4) return Verdict::same;
        const ExactHit exact(scene, ray, ours.triangle);
        const double apart = std::abs(double{embree.t} - double{ours.t});
        if (apart <= rounding_t(exact)) return Verdict::same;
        return std::abs(double{ours.t} - exact.t) <= rounding_t(exact) ? Verdict::peer
                                                                       : Verdict::wrong;
    }
    if (!embree.missed() && !ours.missed() && ulps_between(embree.t, ours.t) <= 4)
        return Verdict::tie;
    const bool ours_nearer = embree.missed() || (!ours.missed() && ours.t < embree.t);
    const Hit& nearer = ours_nearer ? ours : embree;
    const Hit& other = ours_nearer ? embree : ours;
    const ExactHit exact(scene, ray, nearer.triangle);
    if (!other.missed()) {
        const ExactHit exact_other(scene, ray, other.triangle);
        const double apart = std::abs(exact.t - exact_other.t);
        if (ulps_between(static_cast<float>(exact.t), static_cast<float>(exact_other.t)) <= 4)
            return Verdict::exact_tie;
        if (apart <= rounding_t(exact) + rounding_t(exact_other)) return Verdict::grazing;
    }
    if (exact.edge_distance_m() <= kRounding * exact.reach_m) return Verdict::edge;
    if (std::min(std::abs(exact.t - double{ray.t_min}), std::abs(exact.t - double{ray.t_max})) <=
        rounding_t(exact))
        return Verdict::range;
    if (on_texel_border(scene, nearer.triangle, exact)) return Verdict::texel;
    // Beyond all that, double precision says who is right: Embree rounds weights of flat triangles
    // by more, and has none of triangles below 1e-18.
    const auto met = [&](const Hit& hit) {
        return meets_matter(scene, hit.triangle, ExactHit(scene, ray, hit.triangle));
    };
    const bool right = met(nearer) == ours_nearer && (ours.missed() || met(ours));
    return right ? Verdict::peer : Verdict::wrong;
}

}  // namespace foverig::bench
