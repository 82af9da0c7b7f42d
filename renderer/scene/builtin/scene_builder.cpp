#include "renderer/scene/builtin/scene_builder.h"

#include <algorithm>

#include "renderer/check.h"

namespace foverig::builtin {
namespace {

template <class T>
void take(std::vector<T>& to, std::vector<T>&& from) {
    if (to.empty()) {
        to = std::move(from);
    } else {
        to.insert(to.end(), from.begin(), from.end());
        from = {};
    }
}

}  // namespace

std::uint16_t SceneBuilder::add_material(const Material& material) {
    RIG_CHECK(scene_.materials.size() < 65'535, "a triangle names its material with 16 bits");
    scene_.materials.push_back(material);
    return static_cast<std::uint16_t>(scene_.materials.size() - 1);
}

std::uint16_t SceneBuilder::add_matte(const vec3& colour) {
    Material material;
    material.diffuse = colour;
    return add_material(material);
}

std::uint16_t SceneBuilder::add_textured(const Canvas& canvas, float shine) {
    Material material;
    material.diffuse = vec3{1.0F};
    material.specular = vec3{shine};
    material.shininess = 32.0F;
    material.diffuse_texture = add_texture(canvas);
    return add_material(material);
}

std::uint16_t SceneBuilder::add_cut_out(const Canvas& canvas) {
    const std::uint16_t index = add_textured(canvas);
    scene_.materials[index].alpha_cutoff = 0.5F;
    return index;
}

std::uint16_t SceneBuilder::add_glowing(const vec3& radiance) {
    Material material;
    material.emission = radiance;
    return add_material(material);
}

std::int32_t SceneBuilder::add_texture(const Canvas& canvas) {
    scene_.textures.push_back(append_mip_chain(scene_.texels, canvas));
    return static_cast<std::int32_t>(scene_.textures.size() - 1);
}

void SceneBuilder::add_part(Mesh&& mesh, bool alpha_masked) {
    if (mesh.triangles.empty()) return;
    Part part;
    part.first_triangle = static_cast<std::uint32_t>(scene_.triangles.size());
    part.triangle_count = static_cast<std::uint32_t>(mesh.triangles.size());
    part.first_vertex = static_cast<std::uint32_t>(scene_.positions_m.size());
    part.vertex_count = static_cast<std::uint32_t>(mesh.positions_m.size());
    part.alpha_masked = alpha_masked;
    for (uvec3& t : mesh.triangles) t += part.first_vertex;
    take(scene_.positions_m, std::move(mesh.positions_m));
    take(scene_.normals, std::move(mesh.normals));
    take(scene_.texcoords, std::move(mesh.texcoords));
    take(scene_.triangles, std::move(mesh.triangles));
    take(scene_.triangle_materials, std::move(mesh.materials));
    scene_.parts.push_back(part);
}

void SceneBuilder::add_moving_part(Mesh&& mesh, const Motion& motion) {
    const std::size_t before = scene_.parts.size();
    add_part(std::move(mesh));
    if (scene_.parts.size() == before) return;
    scene_.parts.back().motion = static_cast<std::int32_t>(scene_.motions.size());
    scene_.motions.push_back(motion);
}

Scene SceneBuilder::finish() {
    RIG_CHECK(!scene_.positions_m.empty(), "a scene has something in it");
    scene_.bounds = {scene_.positions_m.front(), scene_.positions_m.front()};
    for (const vec3& p : scene_.positions_m) {
        scene_.bounds.min_m = glm::min(scene_.bounds.min_m, p);
        scene_.bounds.max_m = glm::max(scene_.bounds.max_m, p);
    }
    if (scene_.textures.empty()) scene_.texcoords = {};
    return std::move(scene_);
}

}  // namespace foverig::builtin
