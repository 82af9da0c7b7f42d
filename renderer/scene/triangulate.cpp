#include "renderer/scene/triangulate.h"

#include <algorithm>
#include <cmath>

namespace foverig::scene_import {
namespace {

double cross(const dvec2& a, const dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// Twice the signed area of a, b, c.
double area2(const dvec2& a, const dvec2& b, const dvec2& c) {
    return cross(b - a, c - a);
}

/// Newell's normal: right for polygons that are concave or not quite planar. Not normalised.
dvec3 newell_normal(std::span<const dvec3> corners) {
    dvec3 normal(0.0);
    const dvec3 base = corners.front();
    for (std::size_t i = 0; i < corners.size(); ++i)
        normal += glm::cross(corners[i] - base, corners[(i + 1) % corners.size()] - base);
    return normal;
}

/// Counter-clockwise in the plane most square to `normal`.
std::vector<dvec2> projected(std::span<const dvec3> corners, const dvec3& normal) {
    const dvec3 size = glm::abs(normal);
    const int drop = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const int first = (drop + 1) % 3;
    const int second = (drop + 2) % 3;
    const double sign = normal[drop] < 0.0 ? -1.0 : 1.0;
    std::vector<dvec2> flat;
    flat.reserve(corners.size());
    for (const dvec3& p : corners)
        flat.emplace_back(sign * (p[first] - corners.front()[first]),
                          p[second] - corners.front()[second]);
    return flat;
}

}  // namespace

void Triangulator::triangulate(std::span<const dvec3> corners, std::vector<uvec3>& triangles) {
    if (corners.size() < 3) return;
    if (corners.size() == 3) {
        triangles.emplace_back(0, 1, 2);
        return;
    }
    const dvec3 normal = newell_normal(corners);
    if (!std::isfinite(normal.x + normal.y + normal.z)) {
        for (std::uint32_t i = 2; i < corners.size(); ++i) triangles.emplace_back(0, i - 1, i);
        return;
    }
    clip_ears(projected(corners, normal), triangles);
}

void Triangulator::clip_ears(std::span<const dvec2> corners, std::vector<uvec3>& triangles) {
    const auto n = static_cast<std::uint32_t>(corners.size());
    std::vector<std::uint32_t> next(n);
    std::vector<std::uint32_t> previous(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        next[i] = (i + 1) % n;
        previous[i] = (i + n - 1) % n;
    }
    // Only reflex corners can lie inside an ear.
    std::vector<std::uint32_t> reflex;
    for (std::uint32_t i = 0; i < n; ++i)
        if (area2(corners[previous[i]], corners[i], corners[next[i]]) <= 0.0) reflex.push_back(i);
    const auto is_ear = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (area2(corners[a], corners[b], corners[c]) <= 0.0) return false;
        budget_ -= static_cast<std::int64_t>(reflex.size());
        return std::none_of(reflex.begin(), reflex.end(), [&](std::uint32_t r) {
            if (r == a || r == b || r == c) return false;
            const dvec2& p = corners[r];
            if (p == corners[a] || p == corners[b] || p == corners[c]) return false;
            return area2(corners[a], corners[b], p) >= 0.0 &&
                   area2(corners[b], corners[c], p) >= 0.0 &&
                   area2(corners[c], corners[a], p) >= 0.0;
        });
    };
    std::uint32_t left = n;
    std::uint32_t at = 0;
    std::uint32_t tried = 0;
    // A convex quad may be cut either way; the shorter diagonal makes the better triangles.
    if (n == 4)
        at = glm::distance(corners[1], corners[3]) < glm::distance(corners[0], corners[2]) ? 0 : 1;
    while (left > 3 && tried < left && budget_ > 0) {
        const std::uint32_t a = previous[at];
        const std::uint32_t c = next[at];
        if (!is_ear(a, at, c)) {
            at = c;
            ++tried;
            continue;
        }
        triangles.emplace_back(a, at, c);
        next[a] = c;
        previous[c] = a;
        --left;
        tried = 0;
        // Going on two corners further keeps a round polygon from becoming a fan of slivers.
        at = next[c];
    }
    const std::uint32_t hub = at;
    for (std::uint32_t i = next[hub]; next[i] != hub; i = next[i])
        triangles.emplace_back(hub, i, next[i]);
}

}  // namespace foverig::scene_import
