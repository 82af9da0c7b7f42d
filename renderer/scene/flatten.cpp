#include "renderer/scene/flatten.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/scene/import_error.h"
#include "renderer/scene/normals.h"

namespace foverig::scene_import {
namespace {

inline constexpr std::uint32_t kUnset = std::numeric_limits<std::uint32_t>::max();

struct DropCounts {
    std::uint64_t non_finite = 0;
    std::uint64_t zero_area = 0;
};

struct WideBounds {
    dvec3 min{std::numeric_limits<double>::infinity()};
    dvec3 max{-std::numeric_limits<double>::infinity()};

    void add(const dvec3& p) {
        min = glm::min(min, p);
        max = glm::max(max, p);
    }
};

/// Of the vertices that triangles use.
WideBounds bounds_of(const ImportedMesh& mesh) {
    WideBounds bounds;
    for (const uvec3& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) bounds.add(mesh.positions[t[k]]);
    return bounds;
}

dvec3 transformed(const dmat4& m, const dvec3& p) {
    return dvec3(m[0]) * p.x + dvec3(m[1]) * p.y + dvec3(m[2]) * p.z + dvec3(m[3]);
}

WideBounds bounds_of(const ImportedScene& imported) {
    std::vector<WideBounds> of_mesh;
    of_mesh.reserve(imported.meshes.size());
    for (const ImportedMesh& mesh : imported.meshes) of_mesh.push_back(bounds_of(mesh));
    WideBounds bounds;
    for (const MeshInstance& instance : imported.instances) {
        const WideBounds& box = of_mesh[instance.mesh];
        if (imported.meshes[instance.mesh].triangles.empty()) continue;
        for (unsigned corner = 0; corner < 8; ++corner)
            bounds.add(transformed(instance.world_from_mesh,
                                   dvec3((corner & 1U) != 0 ? box.max.x : box.min.x,
                                         (corner & 2U) != 0 ? box.max.y : box.min.y,
                                         (corner & 4U) != 0 ? box.max.z : box.min.z)));
    }
    return bounds;
}

/// Float keeps 24 bits; a scene 4 times its own size from its origin has lost 3 of them, enough to
/// flatten slivers.
dvec3 choose_origin_m(const WideBounds& bounds_m) {
    const dvec3 centre = 0.5 * bounds_m.min + 0.5 * bounds_m.max;
    return glm::length(centre) > 4.0 * glm::length(bounds_m.max - bounds_m.min) ? centre
                                                                                : dvec3(0.0);
}

/// Squares of lengths, areas and their products must stay inside float's range.
void check_extent(const WideBounds& bounds_m, const ImportContext& context) {
    const double extent_m = glm::length(bounds_m.max - bounds_m.min);
    if (!(extent_m < 1.0e15))
        fail(context.file,
             "spans {:.3g} m, more than the 1e15 m that single precision can render; import it "
             "with a smaller metres_per_unit than {:.3g}",
             extent_m, context.settings.metres_per_unit);
    if (extent_m > 0.0 && extent_m < 1.0e-9)
        fail(context.file,
             "spans {:.3g} m, less than the 1e-9 m that single precision can render; import it "
             "with a larger metres_per_unit than {:.3g}",
             extent_m, context.settings.metres_per_unit);
}

void check_count(const ImportedScene& imported, const ImportContext& context) {
    std::uint64_t triangles = 0;
    std::uint64_t vertices = 0;
    for (const MeshInstance& instance : imported.instances) {
        triangles += imported.meshes[instance.mesh].triangles.size();
        vertices += imported.meshes[instance.mesh].positions.size();
        if (triangles > context.settings.max_triangles)
            fail(context.file,
                 "unfolds to more than {} triangles; raise max_triangles or take a smaller scene",
                 context.settings.max_triangles);
        if (vertices >= kUnset)
            fail(context.file, "unfolds to more than 2^32 vertices; take a smaller scene");
    }
}

/// Whether the edges of rounded corners span anything. The sine that counts as none is far below
/// what floats resolve and above the noise of a contracted cross product of equal edges.
bool has_area(const vec3& a, const vec3& b, const vec3& c) {
    const dvec3 u = dvec3(b) - dvec3(a);
    const dvec3 v = dvec3(c) - dvec3(a);
    const dvec3 n = glm::cross(u, v);
    return glm::dot(n, n) > 0x1.0p-96 * glm::dot(u, u) * glm::dot(v, v);
}

/// Writes instances into the scene's arrays, one after the other.
class Unfolder {
  public:
    Unfolder(Scene& scene, const dvec3& origin_m, double metres_per_unit)
        : scene_(scene), origin_m_(origin_m), metres_per_unit_(metres_per_unit) {}

    /// Only the triangles whose material's maskedness is `masked`.
    void add(const ImportedMesh& mesh, const dmat4& world_from_mesh,
             const std::vector<bool>& masked_materials, bool masked, DropCounts& drops) {
        place(mesh, world_from_mesh);
        vertex_of_.assign(mesh.positions.size(), kUnset);
        const Axes linear(world_from_mesh);
        const bool mirrored = glm::dot(linear.x, glm::cross(linear.y, linear.z)) < 0.0;
        // Cofactors: right for any matrix, singular ones included.
        const dvec3 cofactor[3] = {glm::cross(linear.y, linear.z), glm::cross(linear.z, linear.x),
                                   glm::cross(linear.x, linear.y)};
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            if (masked_materials[mesh.materials[t]] != masked) continue;
            uvec3 corners = mesh.triangles[t];
            if (mirrored) std::swap(corners.y, corners.z);
            const vec3& a = placed_m_[corners.x];
            const vec3& b = placed_m_[corners.y];
            const vec3& c = placed_m_[corners.z];
            if (!std::isfinite(a.x + a.y + a.z + b.x + b.y + b.z + c.x + c.y + c.z)) {
                ++drops.non_finite;
                continue;
            }
            if (!has_area(a, b, c)) {
                ++drops.zero_area;
                continue;
            }
            uvec3 triangle;
            for (int k = 0; k < 3; ++k)
                triangle[k] = vertex(mesh, corners[k], cofactor, mirrored, corners);
            scene_.triangles.push_back(triangle);
            scene_.triangle_materials.push_back(mesh.materials[t]);
        }
    }

  private:
    struct Axes {
        dvec3 x, y, z;
        explicit Axes(const dmat4& m) : x(m[0]), y(m[1]), z(m[2]) {}
    };

    void place(const ImportedMesh& mesh, const dmat4& world_from_mesh) {
        placed_m_.resize(mesh.positions.size());
        for (std::size_t i = 0; i < placed_m_.size(); ++i)
            placed_m_[i] = vec3(transformed(world_from_mesh, mesh.positions[i]) * metres_per_unit_ -
                                origin_m_);
    }

    std::uint32_t vertex(const ImportedMesh& mesh, std::uint32_t source, const dvec3 (&cofactor)[3],
                         bool mirrored, const uvec3& corners) {
        std::uint32_t& index = vertex_of_[source];
        if (index != kUnset) return index;
        index = static_cast<std::uint32_t>(scene_.positions_m.size());
        scene_.positions_m.push_back(placed_m_[source]);
        const vec3& n = mesh.normals[source];
        dvec3 normal =
            cofactor[0] * double{n.x} + cofactor[1] * double{n.y} + cofactor[2] * double{n.z};
        if (mirrored) normal = -normal;
        double length = glm::length(normal);
        if (!(length > 0.0 && std::isfinite(length))) {
            const dvec3 a(placed_m_[corners.x]);
            normal = glm::cross(dvec3(placed_m_[corners.y]) - a, dvec3(placed_m_[corners.z]) - a);
            length = glm::length(normal);
        }
        scene_.normals.push_back(vec3(normal / length));
        if (!scene_.textures.empty())
            scene_.texcoords.push_back(mesh.texcoords.empty() ? vec2(0.0F)
                                                              : sane(mesh.texcoords[source]));
        return index;
    }

    /// Beyond this a float has no fraction worth sampling with, and conversions to int would
    /// overflow.
    static vec2 sane(const vec2& uv) {
        const auto one = [](float x) {
            return std::isfinite(x) && std::abs(x) < 1.0e6F ? x : 0.0F;
        };
        return {one(uv.x), one(uv.y)};
    }

    Scene& scene_;
    dvec3 origin_m_;
    double metres_per_unit_;
    std::vector<vec3> placed_m_;
    std::vector<std::uint32_t> vertex_of_;
};

std::vector<bool> masked_materials(const Scene& scene) {
    std::vector<bool> masked(scene.materials.size());
    for (std::size_t i = 0; i < masked.size(); ++i) {
        const Material& material = scene.materials[i];
        masked[i] = material.alpha_cutoff > 0.0F && material.diffuse_texture >= 0 &&
                    scene.textures[static_cast<std::size_t>(material.diffuse_texture)].has_alpha;
    }
    return masked;
}

void note_drops(Scene& scene, const DropCounts& drops) {
    if (drops.non_finite > 0)
        scene.notes.push_back(fmt::format("{} triangles left out: a corner is not a finite number",
                                          drops.non_finite));
    if (drops.zero_area > 0)
        scene.notes.push_back(
            fmt::format("{} triangles left out: they have no area", drops.zero_area));
}

}  // namespace

void flatten(ImportedScene& imported, const ImportContext& context) {
    Scene& scene = imported.scene;
    DropCounts drops;
    for (ImportedMesh& mesh : imported.meshes) {
        drops.non_finite += drop_non_finite(mesh);
        complete_normals(mesh);
    }
    check_count(imported, context);

    WideBounds bounds_m = bounds_of(imported);
    bounds_m.min *= context.settings.metres_per_unit;
    bounds_m.max *= context.settings.metres_per_unit;
    const bool any = bounds_m.min.x <= bounds_m.max.x;
    if (any) check_extent(bounds_m, context);
    scene.origin_m = any ? choose_origin_m(bounds_m) : dvec3(0.0);

    const std::vector<bool> masked = masked_materials(scene);
    Unfolder unfolder(scene, scene.origin_m, context.settings.metres_per_unit);
    for (const bool want_masked : {false, true}) {
        Part part;
        part.first_triangle = static_cast<std::uint32_t>(scene.triangles.size());
        part.first_vertex = static_cast<std::uint32_t>(scene.positions_m.size());
        part.alpha_masked = want_masked;
        for (const MeshInstance& instance : imported.instances) {
            const ImportedMesh& mesh = imported.meshes[instance.mesh];
            const bool some =
                std::any_of(mesh.materials.begin(), mesh.materials.end(),
                            [&](std::uint16_t m) { return masked[m] == want_masked; });
            if (some) unfolder.add(mesh, instance.world_from_mesh, masked, want_masked, drops);
        }
        part.triangle_count =
            static_cast<std::uint32_t>(scene.triangles.size()) - part.first_triangle;
        part.vertex_count =
            static_cast<std::uint32_t>(scene.positions_m.size()) - part.first_vertex;
        if (part.triangle_count > 0) scene.parts.push_back(part);
    }
    note_drops(scene, drops);
    if (scene.triangles.empty())
        fail(context.file,
             "has no triangle to show ({} without area and {} with a corner that is not finite "
             "were left out); a mesh of at least one triangle is needed",
             drops.zero_area, drops.non_finite);
    imported.meshes.clear();
    imported.instances.clear();
}

}  // namespace foverig::scene_import
