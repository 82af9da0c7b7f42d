#include <cmath>
#include <istream>
#include <limits>
#include <streambuf>
#include <string_view>

#include "renderer/scene/import_error.h"
#include "renderer/scene/obj_materials.h"
#include "renderer/scene/triangulate.h"
#include "renderer/scene/vertex_index.h"

namespace foverig::scene_import {
namespace {

/// Reads from memory that someone else owns.
struct ViewBuffer : std::streambuf {
    explicit ViewBuffer(std::string& text) {
        setg(text.data(), text.data(), text.data() + text.size());
    }
};

bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

/// Three numbers of plain digits: nan, inf and 1.#IND, which tinyobjloader reads as 0 or 1, are
/// not.
bool is_plain_position(std::string_view line) {
    std::size_t at = 0;
    for (int k = 0; k < 3; ++k) {
        while (at < line.size() && is_blank(line[at])) ++at;
        const std::size_t begin = at;
        bool digit = false;
        for (; at < line.size() && !is_blank(line[at]) && line[at] != '\r'; ++at) {
            const char c = line[at];
            digit = digit || (c >= '0' && c <= '9');
            if ((c < '0' || c > '9') && c != '+' && c != '-' && c != '.' && c != 'e' && c != 'E')
                return false;
        }
        if (!digit || at == begin) return false;
    }
    return true;
}

/// Which `v` lines (counted from 0) hold no three plain numbers. Throws where the file is not text.
std::vector<std::uint32_t> odd_positions(std::string_view text, const ImportContext& context) {
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos)
        fail(context.file, "is not OBJ text: byte {} is 0", zero);
    std::vector<std::uint32_t> odd;
    std::uint32_t vertex = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        // tinyobjloader ends a line at either.
        const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
        std::string_view line = text.substr(begin, end - begin);
        while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
        if (line.size() > 1 && line[0] == 'v' && is_blank(line[1])) {
            if (!is_plain_position(line.substr(2))) odd.push_back(vertex);
            ++vertex;
        }
        begin = end + 1;
    }
    return odd;
}

/// Receives tinyobjloader's events and builds one mesh.
class ObjBuilder {
  public:
    ObjBuilder(ImportedScene& imported, const ImportContext& context,
               std::vector<std::uint32_t> odd)
        : context_(context), materials_(imported, context), odd_(std::move(odd)) {}

    void add_position(const dvec3& p) {
        const bool odd = next_odd_ < odd_.size() && odd_[next_odd_] == positions_.size();
        next_odd_ += odd ? 1 : 0;
        positions_.push_back(odd ? dvec3(std::numeric_limits<double>::quiet_NaN()) : p);
    }
    void add_normal(const dvec3& n) { normals_.emplace_back(n); }
    void add_texcoord(const dvec2& t) { texcoords_.emplace_back(t.x, 1.0 - t.y); }

    void use_material(const char* name) {
        material_name_ = name;
        material_ = kNone;
    }

    void add_face(const tinyobj::index_t* corners, std::size_t count) {
        ++face_count_;
        if (count < 3) return;
        if (material_ == kNone) material_ = materials_.material(material_name_);
        polygon_.clear();
        polygon_positions_.clear();
        for (std::size_t i = 0; i < count; ++i) {
            const std::int64_t v = resolved(corners[i].vertex_index, positions_.size());
            if (v == kNone)
                fail(context_.file,
                     "face {} names position {}, but {} are there before it; indices start at 1",
                     face_count_, corners[i].vertex_index, positions_.size());
            polygon_positions_.push_back(positions_[static_cast<std::size_t>(v)]);
            polygon_.push_back(vertex(static_cast<std::uint32_t>(v),
                                      resolved(corners[i].texcoord_index, texcoords_.size()),
                                      resolved(corners[i].normal_index, normals_.size())));
        }
        triangles_.clear();
        triangulator_.triangulate(polygon_positions_, triangles_);
        for (const uvec3& t : triangles_) {
            mesh_.triangles.emplace_back(polygon_[t.x], polygon_[t.y], polygon_[t.z]);
            mesh_.materials.push_back(static_cast<std::uint16_t>(material_));
        }
        if (mesh_.triangles.size() > context_.settings.max_triangles)
            fail(context_.file,
                 "holds more than {} triangles; raise max_triangles or take a smaller scene",
                 context_.settings.max_triangles);
    }

    ImportedMesh finish() {
        if (!any_normal_) mesh_.normals.clear();
        return std::move(mesh_);
    }

    ObjMaterials& materials() { return materials_; }
    std::size_t face_count() const { return face_count_; }

  private:
    /// From OBJ's index (from 1, or negative from the end) to ours; kNone where there is no such
    /// thing.
    static std::int64_t resolved(int index, std::size_t count) {
        const std::int64_t i =
            index > 0 ? index - std::int64_t{1} : static_cast<std::int64_t>(count) + index;
        return index != 0 && i >= 0 && i < static_cast<std::int64_t>(count) ? i : kNone;
    }

    std::uint32_t vertex(std::uint32_t position, std::int64_t texcoord, std::int64_t normal) {
        const auto fresh = static_cast<std::uint32_t>(mesh_.positions.size());
        const std::uint32_t found = vertices_.find_or_add({position, texcoord, normal}, fresh);
        if (found != fresh) return found;
        mesh_.positions.push_back(positions_[position]);
        mesh_.texcoords.push_back(
            texcoord == kNone ? vec2(0.0F) : texcoords_[static_cast<std::size_t>(texcoord)]);
        mesh_.normals.push_back(normal == kNone ? vec3(0.0F)
                                                : normals_[static_cast<std::size_t>(normal)]);
        any_normal_ = any_normal_ || normal != kNone;
        return fresh;
    }

    const ImportContext& context_;
    ObjMaterials materials_;
    std::vector<std::uint32_t> odd_;
    std::size_t next_odd_ = 0;
    std::vector<dvec3> positions_;
    std::vector<vec3> normals_;
    std::vector<vec2> texcoords_;
    std::string material_name_;
    std::int32_t material_ = kNone;
    std::size_t face_count_ = 0;
    bool any_normal_ = false;
    VertexIndex vertices_;
    Triangulator triangulator_;
    ImportedMesh mesh_;
    std::vector<std::uint32_t> polygon_;
    std::vector<dvec3> polygon_positions_;
    std::vector<uvec3> triangles_;
};

ObjBuilder& builder(void* user) {
    return *static_cast<ObjBuilder*>(user);
}

tinyobj::callback_t callbacks() {
    tinyobj::callback_t c;
    c.vertex_cb = [](void* u, double x, double y, double z, double /*w*/) {
        builder(u).add_position({x, y, z});
    };
    c.normal_cb = [](void* u, double x, double y, double z) { builder(u).add_normal({x, y, z}); };
    c.texcoord_cb = [](void* u, double x, double y, double /*z*/) {
        builder(u).add_texcoord({x, y});
    };
    c.index_cb = [](void* u, tinyobj::index_t* corners, int count) {
        builder(u).add_face(corners, static_cast<std::size_t>(count));
    };
    c.usemtl_cb = [](void* u, const char* name, int /*index*/) { builder(u).use_material(name); };
    return c;
}

}  // namespace

ImportedScene import_obj(const ImportContext& context) {
    std::string text = read_file(context.file);
    ImportedScene imported;
    ObjBuilder builder_of_mesh(imported, context, odd_positions(text, context));
    ViewBuffer buffer(text);
    std::istream stream(&buffer);
    tinyobj::LoadObjWithCallback(stream, callbacks(), &builder_of_mesh,
                                 &builder_of_mesh.materials());
    imported.meshes.push_back(builder_of_mesh.finish());
    imported.instances.push_back({0, dmat4(1.0)});
    if (builder_of_mesh.face_count() == 0)
        fail(context.file, "holds no face; an OBJ scene needs lines that start with 'f'");
    return imported;
}

}  // namespace foverig::scene_import
