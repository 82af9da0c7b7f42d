#include <cmath>
#include <limits>

#include "renderer/check.h"
#include "renderer/scene/scene.h"

namespace foverig {
namespace {

void check_geometry(const Scene& scene) {
    const std::size_t vertices = scene.positions_m.size();
    RIG_CHECK(!scene.triangles.empty(), "a scene shows something");
    RIG_CHECK(scene.normals.size() == vertices, "every vertex has a normal");
    RIG_CHECK(
        scene.texcoords.size() == vertices || (scene.texcoords.empty() && scene.textures.empty()),
        "every vertex has texture coordinates, or nothing is textured");
    RIG_CHECK(scene.triangle_materials.size() == scene.triangles.size(),
              "every triangle has a material");
    for (std::size_t i = 0; i < vertices; ++i) {
        const vec3& p = scene.positions_m[i];
        RIG_CHECK(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z),
                  "position {} is finite", i);
        const float length2 = glm::dot(scene.normals[i], scene.normals[i]);
        RIG_CHECK(std::abs(length2 - 1.0F) < 1.0e-3F, "normal {} has unit length", i);
    }
    for (const uvec3& t : scene.triangles)
        RIG_CHECK(t.x < vertices && t.y < vertices && t.z < vertices,
                  "triangles name vertices that are there");
    for (const std::uint16_t material : scene.triangle_materials)
        RIG_CHECK(material < scene.materials.size(), "triangles name materials that are there");
}

void check_parts(const Scene& scene) {
    std::size_t triangle = 0;
    for (const Part& part : scene.parts) {
        RIG_CHECK(part.first_triangle == triangle, "parts follow one another without a gap");
        triangle += part.triangle_count;
        RIG_CHECK(triangle <= scene.triangles.size(), "a part lies inside the triangles");
        RIG_CHECK(std::size_t{part.first_vertex} + part.vertex_count <= scene.positions_m.size(),
                  "a part lies inside the vertices");
        RIG_CHECK(
            part.motion >= kNone && part.motion < static_cast<std::int64_t>(scene.motions.size()),
            "a part's motion is there");
        for (std::size_t t = part.first_triangle; t < triangle; ++t)
            for (int k = 0; k < 3; ++k)
                RIG_CHECK(scene.triangles[t][k] - part.first_vertex < part.vertex_count,
                          "triangle {} stays inside its part's vertices", t);
    }
    RIG_CHECK(triangle == scene.triangles.size(), "every triangle belongs to a part");
}

void check_textures(const Scene& scene) {
    for (const Texture& texture : scene.textures) {
        RIG_CHECK(texture.width > 0 && texture.height > 0 && texture.level_count > 0,
                  "a texture has texels");
        std::size_t end = texture.first_texel;
        for (std::uint32_t level = 0; level < texture.level_count; ++level)
            end += std::size_t{std::max(1U, texture.width >> level)} *
                   std::max(1U, texture.height >> level);
        RIG_CHECK(end <= scene.texels.size(), "a texture's mip chain lies inside the texels");
    }
    const auto count = static_cast<std::int64_t>(scene.textures.size());
    for (const Material& material : scene.materials) {
        RIG_CHECK(material.diffuse_texture >= kNone && material.diffuse_texture < count,
                  "a material's texture is there");
        RIG_CHECK(material.emission_texture >= kNone && material.emission_texture < count,
                  "a material's texture is there");
        RIG_CHECK(material.shininess >= 1.0F, "a Phong exponent is at least 1");
    }
}

}  // namespace

void check_scene(const Scene& scene) {
    check_geometry(scene);
    check_parts(scene);
    check_textures(scene);
    RIG_CHECK(!scene.camera_path.empty(), "a scene has a camera key");
    RIG_CHECK(scene.camera_path_s > 0.0F, "a flight takes time");
}

void update_bounds(Scene& scene) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    Bounds bounds{vec3(kInfinity), vec3(-kInfinity)};
    for (const vec3& p : scene.positions_m) {
        bounds.min_m = glm::min(bounds.min_m, p);
        bounds.max_m = glm::max(bounds.max_m, p);
    }
    scene.bounds = scene.positions_m.empty() ? Bounds{} : bounds;
}

}  // namespace foverig
