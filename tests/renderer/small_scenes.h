#pragma once
// Scenes of a few polygons, for tests that know the answer.
#include <cmath>
#include <memory>

#include "renderer/renderer.h"

namespace foverig {

/// Makes one part of all triangles added so far when finished.
class SmallScene {
  public:
    SmallScene() {
        scene_.name = "small";
        scene_.ambient = vec3(0.0F);
        scene_.camera_path = {CameraKey{}};
    }

    Scene& scene() { return scene_; }
    std::uint16_t add_material(const Material& m) {
        scene_.materials.push_back(m);
        return static_cast<std::uint16_t>(scene_.materials.size() - 1);
    }
    std::uint16_t add_matte(const vec3& diffuse) {
        Material m;
        m.diffuse = diffuse;
        return add_material(m);
    }
    /// Parallelogram with texture coordinates 0..1; its normal is cross(u, v).
    void add_quad(std::uint16_t material, const vec3& corner_m, const vec3& u_m, const vec3& v_m) {
        const auto first = static_cast<std::uint32_t>(scene_.positions_m.size());
        const vec3 normal = glm::normalize(glm::cross(u_m, v_m));
        for (const vec2 at : {vec2(0, 0), vec2(1, 0), vec2(1, 1), vec2(0, 1)}) {
            scene_.positions_m.push_back(corner_m + at.x * u_m + at.y * v_m);
            scene_.normals.push_back(normal);
            texcoords_.push_back(at);
        }
        scene_.triangles.push_back({first, first + 1, first + 2});
        scene_.triangles.push_back({first, first + 2, first + 3});
        scene_.triangle_materials.insert(scene_.triangle_materials.end(), 2, material);
    }
    /// Closes the part begun since the last call; the next quads belong to a new one.
    void end_part(bool alpha_masked = false) {
        Part part;
        for (const Part& p : scene_.parts) {
            part.first_triangle += p.triangle_count;
            part.first_vertex += p.vertex_count;
        }
        part.triangle_count =
            static_cast<std::uint32_t>(scene_.triangles.size()) - part.first_triangle;
        part.vertex_count =
            static_cast<std::uint32_t>(scene_.positions_m.size()) - part.first_vertex;
        part.alpha_masked = alpha_masked;
        if (part.triangle_count > 0) scene_.parts.push_back(part);
    }
    std::shared_ptr<const Scene> finish() {
        end_part();
        if (!scene_.textures.empty()) scene_.texcoords = texcoords_;
        update_bounds(scene_);
        check_scene(scene_);
        return std::make_shared<const Scene>(scene_);
    }

  private:
    Scene scene_;
    std::vector<vec2> texcoords_;
};

/// Looks along -z from `position_m` turned to `target_m`, tangents +-`tangent`.
inline EyeView view_at(const vec3& position_m, const vec3& target_m, int width_px, int height_px,
                       float tangent = 1.0F) {
    EyeView v;
    v.width_px = width_px;
    v.height_px = height_px;
    v.tan_left = v.tan_right = tangent;
    v.tan_down = v.tan_up = tangent * static_cast<float>(height_px) / static_cast<float>(width_px);
    v.position_m = position_m;
    const vec3 back = glm::normalize(position_m - target_m);
    const vec3 helper = std::abs(back.y) > 0.99F ? vec3(1, 0, 0) : vec3(0, 1, 0);
    const vec3 right = glm::normalize(glm::cross(helper, back));
    v.world_from_eye = mat3(right, glm::cross(back, right), back);
    return v;
}

inline FrameInput frame_of(const EyeView& view, std::uint32_t frame = 0) {
    FrameInput input;
    input.frame = frame;
    input.eyes.push_back({view, vec3(0.0F, 0.0F, -1.0F)});
    return input;
}

inline RenderSettings settings_of(const char* pipeline) {
    RenderSettings s;
    s.pipeline = pipeline;
    s.threads = 2;
    return s;
}

/// World point on the plane y = height that the middle of pixel (x, y) shows.
inline dvec3 floor_point(const EyeView& v, int x_px, int y_px, double height_m = 0.0) {
    const double tx = -static_cast<double>(v.tan_left) +
                      (x_px + 0.5) / v.width_px *
                          (static_cast<double>(v.tan_left) + static_cast<double>(v.tan_right));
    const double ty = static_cast<double>(v.tan_up) -
                      (y_px + 0.5) / v.height_px *
                          (static_cast<double>(v.tan_up) + static_cast<double>(v.tan_down));
    const dvec3 d = dmat3(v.world_from_eye) * dvec3(tx, ty, -1.0);
    const dvec3 o(v.position_m);
    return o + d * ((height_m - o.y) / d.y);
}

/// A card whose left half is a hole, a wall 1 m behind it, both facing the origin.
inline Scene card_before_wall() {
    SmallScene s;
    s.scene().textures.push_back({2, 1, 1, 0, false, false, true});
    s.scene().texels = {0x00FFFFFFU, 0xFFFFFFFFU};
    Material leaf;
    leaf.diffuse_texture = 0;
    leaf.alpha_cutoff = 0.5F;
    s.add_quad(s.add_material(leaf), {-1, -1, -1}, {2, 0, 0}, {0, 2, 0});
    s.end_part(true);
    s.add_quad(s.add_matte(vec3(0.5F)), {-4, -4, -2}, {8, 0, 0}, {0, 8, 0});
    return *s.finish();
}

}  // namespace foverig
