#include "renderer/scene/normals.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

namespace foverig::scene_import {
namespace {

inline constexpr std::uint32_t kUnset = std::numeric_limits<std::uint32_t>::max();

/// Sine of an angle that no triangle of float coordinates has but by rounding.
inline constexpr double kNoSine = 0x1.0p-48;

bool is_finite(const dvec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

double largest_component(const dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Zero where the triangle has no direction. Scaled by its longest edge first: coordinates may be
/// anywhere in float's range. A contracted cross product of equal edges is rounding noise, not
/// zero.
dvec3 unit_face_normal(const dvec3& a, const dvec3& b, const dvec3& c) {
    const dvec3 u = b - a;
    const dvec3 v = c - a;
    const double scale = std::max(largest_component(u), largest_component(v));
    if (!(scale > 0.0)) return dvec3(0.0);
    const dvec3 n = glm::cross(u / scale, v / scale);
    const double length = glm::length(n);
    return length > kNoSine * (glm::length(u) / scale) * (glm::length(v) / scale) ? n / length
                                                                                  : dvec3(0.0);
}

double corner_angle_rad(const dvec3& at, const dvec3& p, const dvec3& q) {
    const double largest = std::max(largest_component(p - at), largest_component(q - at));
    if (!(largest > 0.0)) return 0.0;
    const dvec3 u = (p - at) / largest;
    const dvec3 v = (q - at) / largest;
    return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

/// One number for all vertices that share a position.
std::vector<std::uint32_t> welded(const std::vector<dvec3>& positions) {
    const std::size_t slot_count = std::bit_ceil(positions.size() * 2 + 1);
    std::vector<std::uint32_t> slots(slot_count, kUnset);
    std::vector<std::uint32_t> weld(positions.size());
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        std::uint64_t h = 0;
        // + 0.0 makes one of the two zeros.
        for (int k = 0; k < 3; ++k) {
            h = (h ^ std::bit_cast<std::uint64_t>(positions[i][k] + 0.0)) * 0x9E3779B97F4A7C15U;
            h ^= h >> 32U;
        }
        std::size_t slot = h & (slot_count - 1);
        while (slots[slot] != kUnset && positions[slots[slot]] != positions[i])
            slot = (slot + 1) & (slot_count - 1);
        if (slots[slot] == kUnset) slots[slot] = i;
        weld[i] = slots[slot];
    }
    return weld;
}

/// The corners (3 * triangle + k) around each welded vertex, one run after the other.
struct CornerLists {
    std::vector<std::uint32_t> first;  ///< size n + 1
    std::vector<std::uint32_t> corners;
};

CornerLists corner_lists(const ImportedMesh& mesh, const std::vector<std::uint32_t>& weld) {
    CornerLists lists;
    lists.first.assign(mesh.positions.size() + 1, 0);
    for (const uvec3& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) ++lists.first[weld[t[k]] + 1];
    for (std::size_t i = 1; i < lists.first.size(); ++i) lists.first[i] += lists.first[i - 1];
    lists.corners.resize(mesh.triangles.size() * 3);
    std::vector<std::uint32_t> next(lists.first.begin(), lists.first.end() - 1);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::uint32_t k = 0; k < 3; ++k)
            lists.corners[next[weld[mesh.triangles[t][static_cast<int>(k)]]]++] = 3 * t + k;
    return lists;
}

/// Vertices split where their corners' normals differ; texture coordinates go along.
class VertexSplitter {
  public:
    explicit VertexSplitter(ImportedMesh& mesh)
        : mesh_(mesh), first_(mesh.positions.size(), kUnset) {
        positions_.reserve(mesh.positions.size());
        normals_.reserve(mesh.positions.size());
    }

    std::uint32_t vertex(std::uint32_t source, const vec3& normal) {
        for (std::uint32_t v = first_[source]; v != kUnset; v = next_[v])
            if (glm::dot(normals_[v], normal) > 0.9999F) return v;
        const auto v = static_cast<std::uint32_t>(positions_.size());
        positions_.push_back(mesh_.positions[source]);
        normals_.push_back(normal);
        if (!mesh_.texcoords.empty()) texcoords_.push_back(mesh_.texcoords[source]);
        next_.push_back(first_[source]);
        first_[source] = v;
        return v;
    }

    void finish() {
        mesh_.positions = std::move(positions_);
        mesh_.normals = std::move(normals_);
        mesh_.texcoords = std::move(texcoords_);
    }

  private:
    ImportedMesh& mesh_;
    std::vector<std::uint32_t> first_;  ///< newest split vertex of each source vertex
    std::vector<std::uint32_t> next_;
    std::vector<dvec3> positions_;
    std::vector<vec3> normals_;
    std::vector<vec2> texcoords_;
};

void make_normals(ImportedMesh& mesh, double crease_deg) {
    const std::vector<std::uint32_t> weld = welded(mesh.positions);
    const CornerLists around = corner_lists(mesh, weld);
    std::vector<vec3> face_normals(mesh.triangles.size());
    std::vector<float> angles_rad(mesh.triangles.size() * 3);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const uvec3& i = mesh.triangles[t];
        const dvec3 p[3] = {mesh.positions[i.x], mesh.positions[i.y], mesh.positions[i.z]};
        face_normals[t] = vec3(unit_face_normal(p[0], p[1], p[2]));
        for (std::size_t k = 0; k < 3; ++k)
            angles_rad[3 * t + k] =
                static_cast<float>(corner_angle_rad(p[k], p[(k + 1) % 3], p[(k + 2) % 3]));
    }
    // Comparing every pair around a hub of thousands of faces would take for ever; a hub is smooth.
    constexpr std::uint32_t kHub = 64;
    const auto crease_cosine = static_cast<float>(std::cos(crease_deg * std::numbers::pi / 180.0));
    VertexSplitter splitter(mesh);
    std::vector<uvec3> triangles = mesh.triangles;
    for (std::size_t w = 0; w < mesh.positions.size(); ++w) {
        const std::uint32_t begin = around.first[w];
        const std::uint32_t end = around.first[w + 1];
        vec3 hub{0.0F};
        if (end - begin > kHub)
            for (std::uint32_t j = begin; j < end; ++j)
                hub += angles_rad[around.corners[j]] * face_normals[around.corners[j] / 3];
        for (std::uint32_t i = begin; i < end; ++i) {
            const std::uint32_t corner = around.corners[i];
            const vec3& own = face_normals[corner / 3];
            vec3 sum = hub;
            if (end - begin <= kHub)
                for (std::uint32_t j = begin; j < end; ++j) {
                    const std::uint32_t other = around.corners[j];
                    if (glm::dot(own, face_normals[other / 3]) >= crease_cosine)
                        sum += angles_rad[other] * face_normals[other / 3];
                }
            const float length = glm::length(sum);
            // A hub's faces may cancel: then any one direction does, but the same for all.
            const vec3& fallback =
                end - begin > kHub ? face_normals[around.corners[begin] / 3] : own;
            const vec3 normal = length > 1.0e-6F ? sum / length : fallback;
            const int k = static_cast<int>(corner % 3);
            triangles[corner / 3][k] = splitter.vertex(mesh.triangles[corner / 3][k], normal);
        }
    }
    splitter.finish();
    mesh.triangles = std::move(triangles);
}

/// Files store rounded, scaled, zero and NaN normals.
void mend_normals(ImportedMesh& mesh) {
    std::vector<bool> bad(mesh.normals.size());
    bool any = false;
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        const dvec3 n(mesh.normals[i]);
        const double length = glm::length(n);
        bad[i] = !(std::isfinite(length) && length > 1.0e-12);
        if (!bad[i])
            mesh.normals[i] = vec3(n / length);
        else
            mesh.normals[i] = vec3(0.0F);
        any = any || bad[i];
    }
    if (!any) return;
    for (const uvec3& t : mesh.triangles) {
        if (!bad[t.x] && !bad[t.y] && !bad[t.z]) continue;
        const vec3 face(
            unit_face_normal(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]));
        for (int k = 0; k < 3; ++k)
            if (bad[t[k]]) mesh.normals[t[k]] += face;
    }
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        if (!bad[i]) continue;
        const float length = glm::length(mesh.normals[i]);
        if (length > 1.0e-6F)
            mesh.normals[i] /= length;
        else
            mesh.normals[i] = vec3(0.0F);
    }
}

}  // namespace

std::size_t drop_non_finite(ImportedMesh& mesh) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const uvec3& i = mesh.triangles[t];
        if (!is_finite(mesh.positions[i.x]) || !is_finite(mesh.positions[i.y]) ||
            !is_finite(mesh.positions[i.z]))
            continue;
        mesh.triangles[kept] = i;
        mesh.materials[kept] = mesh.materials[t];
        ++kept;
    }
    const std::size_t dropped = mesh.triangles.size() - kept;
    mesh.triangles.resize(kept);
    mesh.materials.resize(kept);
    return dropped;
}

void complete_normals(ImportedMesh& mesh, double crease_deg) {
    if (mesh.normals.empty())
        make_normals(mesh, crease_deg);
    else
        mend_normals(mesh);
}

}  // namespace foverig::scene_import
