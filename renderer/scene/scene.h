#pragma once
// A scene as plain arrays: what importers and generators make, what tracers and kernels read.
// World frame: right-handed, y up, metres, relative to `Scene::origin_m`. Colours are linear RGB.
#include <cstdint>
#include <string>
#include <vector>

#include "renderer/vec.h"

namespace foverig {

inline constexpr std::int32_t kNone = -1;

/// Phong, as in Weier 2016 3.1: diffuse + specular * cos^shininess, with textures and an alpha
/// mask.
struct Material {
    vec3 diffuse{0.8F};
    vec3 specular{0.0F};
    float shininess = 1.0F;     ///< Phong exponent, >= 1
    vec3 emission{0.0F};        ///< radiance
    float reflectance = 0.0F;   ///< mirror share, 0..1 (read by pipelines that trace it)
    float transmission = 0.0F;  ///< see-through share, 0..1
    float ior = 1.5F;
    float alpha_cutoff = 0.0F;  ///< texel alpha below this is a hole; 0 = opaque
    std::int32_t diffuse_texture = kNone;
    std::int32_t emission_texture = kNone;
};

/// RGBA8 in sRGB, mip chain stored level after level, each row by row from the top, in
/// `Scene::texels`; level l is max(1, width >> l) x max(1, height >> l).
struct Texture {
    std::uint32_t width = 1;
    std::uint32_t height = 1;
    std::uint32_t level_count = 1;
    std::uint32_t first_texel = 0;
    bool repeat_u = true;  ///< else clamp to edge
    bool repeat_v = true;
    bool has_alpha = false;  ///< any texel of level 0 below 255
};

/// Rigid motion of a part: p(t) = rotate(axis, rate t) about `pivot_m`, plus a sinusoidal shift.
struct Motion {
    vec3 pivot_m{0.0F};
    vec3 axis{0.0F, 1.0F, 0.0F};
    float rate_rad_s = 0.0F;
    vec3 swing_m{0.0F};  ///< amplitude of the shift
    float swing_hz = 0.0F;
};

/// A run of triangles that one BVH geometry holds. Vertices are not shared between parts that move.
struct Part {
    std::uint32_t first_triangle = 0;
    std::uint32_t triangle_count = 0;
    std::uint32_t first_vertex = 0;
    std::uint32_t vertex_count = 0;
    bool alpha_masked = false;    ///< its triangles need the any-hit alpha test
    std::int32_t motion = kNone;  ///< index into Scene::motions
};

struct PointLight {
    vec3 position_m{0.0F};
    vec3 intensity{1.0F};  ///< W/sr per channel, arbitrary scale
};

/// Parallelogram corner + a*edge_u + b*edge_v, a, b in [0,1]; emits from both sides.
struct AreaLight {
    vec3 corner_m{0.0F};
    vec3 edge_u_m{1.0F, 0.0F, 0.0F};
    vec3 edge_v_m{0.0F, 0.0F, 1.0F};
    vec3 radiance{1.0F};
};

/// A key of the camera path that shows the scene well; the eye looks along target - position.
struct CameraKey {
    vec3 position_m{0.0F};
    vec3 target_m{0.0F, 0.0F, -1.0F};
};

struct Bounds {
    vec3 min_m{0.0F};
    vec3 max_m{0.0F};
};

struct Scene {
    std::string name;
    dvec3 origin_m{0.0};  ///< file position of our (0,0,0), in metres
    Bounds bounds;        ///< of all positions at time 0

    std::vector<vec3> positions_m;
    std::vector<vec3> normals;  ///< unit, one per position
    std::vector<vec2>
        texcoords;  ///< one per position (v = 0: top row), or empty: no texture in the scene
    std::vector<uvec3> triangles;  ///< indices into the three arrays above
    std::vector<std::uint16_t> triangle_materials;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<std::uint32_t> texels;  ///< RGBA8, red in the low byte

    std::vector<Part> parts;
    std::vector<Motion> motions;
    std::vector<PointLight> point_lights;
    std::vector<AreaLight> area_lights;
    vec3 ambient{0.1F};                  ///< ambient radiance, weighted by occlusion
    vec3 background{0.0F};               ///< radiance of a ray that hits nothing
    std::vector<CameraKey> camera_path;  ///< at least one key
    float camera_path_s = 20.0F;         ///< time of one flight along the path

    std::vector<std::string> notes;  ///< sentences for a person: what an importer left out, and why
};

/// Throws InternalError where the arrays disagree; importers and generators call it last.
void check_scene(const Scene& scene);

/// Recomputes `bounds` from the positions.
void update_bounds(Scene& scene);

}  // namespace foverig
