// PLY has no reader of its own among Debian's libraries, and the format is small.
#include <limits>

#include "renderer/scene/import_error.h"
#include "renderer/scene/ply_body.h"
#include "renderer/scene/scene_folder.h"
#include "renderer/scene/triangulate.h"

namespace foverig::scene_import {
namespace {

enum class Target { kNone, kX, kY, kZ, kNormalX, kNormalY, kNormalZ, kU, kV };

Target target_of(const std::string& name) {
    if (name == "x") return Target::kX;
    if (name == "y") return Target::kY;
    if (name == "z") return Target::kZ;
    if (name == "nx") return Target::kNormalX;
    if (name == "ny") return Target::kNormalY;
    if (name == "nz") return Target::kNormalZ;
    if (name == "u" || name == "s" || name == "texture_u") return Target::kU;
    if (name == "v" || name == "t" || name == "texture_v") return Target::kV;
    return Target::kNone;
}

class PlyBuilder {
  public:
    PlyBuilder(PlyBody& body, const ImportContext& context) : body_(body), context_(context) {}

    void read_vertices(const PlyElement& element) {
        std::vector<Target> targets;
        bool has_normals = false;
        unsigned axes = 0;
        for (const PlyProperty& property : element.properties) {
            targets.push_back(property.is_list ? Target::kNone : target_of(property.name));
            has_normals = has_normals || targets.back() == Target::kNormalX;
            if (targets.back() >= Target::kX && targets.back() <= Target::kZ)
                axes |= 1U << static_cast<unsigned>(targets.back());
        }
        if (axes != 14U) fail(context_.file, "its PLY vertices have no x, y and z");
        for (std::uint64_t i = 0; i < element.count; ++i) {
            double values[9] = {};
            for (std::size_t p = 0; p < targets.size(); ++p) {
                if (targets[p] == Target::kNone)
                    body_.skip(element.properties[p]);
                else
                    values[static_cast<std::size_t>(targets[p])] =
                        body_.next(element.properties[p].type);
            }
            mesh_.positions.emplace_back(values[1], values[2], values[3]);
            if (has_normals) mesh_.normals.emplace_back(values[4], values[5], values[6]);
        }
    }

    void read_faces(const PlyElement& element) {
        for (std::uint64_t i = 0; i < element.count; ++i) {
            for (const PlyProperty& property : element.properties) {
                if (!property.is_list ||
                    (property.name != "vertex_indices" && property.name != "vertex_index")) {
                    body_.skip(property);
                    continue;
                }
                read_indices(property, "face", i);
                add_polygon();
            }
        }
    }

    void read_strips(const PlyElement& element) {
        for (std::uint64_t i = 0; i < element.count; ++i) {
            for (const PlyProperty& property : element.properties) {
                if (!property.is_list || property.name != "vertex_indices")
                    body_.skip(property);
                else
                    add_strips(property, i);
            }
        }
    }

    ImportedMesh finish() { return std::move(mesh_); }

  private:
    std::uint32_t checked(double index, const char* what, std::uint64_t number) const {
        if (!(index >= 0.0 && index < static_cast<double>(mesh_.positions.size())))
            fail(context_.file, "{} {} names vertex {} of {}; indices start at 0", what, number,
                 index, mesh_.positions.size());
        return static_cast<std::uint32_t>(index);
    }

    void read_indices(const PlyProperty& property, const char* what, std::uint64_t number) {
        const std::uint64_t count = body_.next_count(property);
        polygon_.clear();
        for (std::uint64_t k = 0; k < count; ++k)
            polygon_.push_back(checked(body_.next(property.type), what, number));
    }

    void add_polygon() {
        corners_.clear();
        for (const std::uint32_t v : polygon_) corners_.push_back(mesh_.positions[v]);
        triangles_.clear();
        triangulator_.triangulate(corners_, triangles_);
        for (const uvec3& t : triangles_) add_triangle(polygon_[t.x], polygon_[t.y], polygon_[t.z]);
    }

    /// Index -1 begins a new strip; every second triangle of a strip is turned round.
    void add_strips(const PlyProperty& property, std::uint64_t number) {
        const std::uint64_t count = body_.next_count(property);
        std::vector<std::uint32_t> strip;
        for (std::uint64_t k = 0; k < count; ++k) {
            const double index = body_.next(property.type);
            if (index == -1.0) {
                strip.clear();
                continue;
            }
            strip.push_back(checked(index, "strip", number));
            const std::size_t n = strip.size();
            if (n < 3) continue;
            const bool odd = n % 2 == 0;
            add_triangle(strip[n - 3], strip[odd ? n - 1 : n - 2], strip[odd ? n - 2 : n - 1]);
        }
    }

    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh_.triangles.emplace_back(a, b, c);
        mesh_.materials.push_back(0);
        if (mesh_.triangles.size() > context_.settings.max_triangles)
            fail(context_.file,
                 "holds more than {} triangles; raise max_triangles or take a smaller scene",
                 context_.settings.max_triangles);
    }

    PlyBody& body_;
    const ImportContext& context_;
    ImportedMesh mesh_;
    Triangulator triangulator_;
    std::vector<std::uint32_t> polygon_;
    std::vector<dvec3> corners_;
    std::vector<uvec3> triangles_;
};

}  // namespace

ImportedScene import_ply(const ImportContext& context) {
    const std::string bytes = read_file(context.file);
    const PlyHeader header = parse_ply_header(bytes, context);
    PlyBody body(bytes, header, context);
    PlyBuilder builder(body, context);
    for (const PlyElement& element : header.elements) {
        if (element.name == "vertex")
            builder.read_vertices(element);
        else if (element.name == "face")
            builder.read_faces(element);
        else if (element.name == "tristrips")
            builder.read_strips(element);
        else
            for (std::uint64_t i = 0; i < element.count; ++i)
                for (const PlyProperty& property : element.properties) body.skip(property);
    }
    ImportedScene imported;
    add_material(imported, Material{}, context);
    imported.meshes.push_back(builder.finish());
    imported.instances.push_back({0, dmat4(1.0)});
    return imported;
}

}  // namespace foverig::scene_import
