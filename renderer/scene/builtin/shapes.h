#pragma once
// Shapes written into a Mesh. Flat ones are mapped along the world axis they face, so that textures
// run on from one piece of a wall to the next.
#include <span>

#include "renderer/scene/builtin/mesh.h"

namespace foverig::builtin {

/// Parallelogram corner, corner + edge_u, ...; faces cross(edge_u, edge_v).
void add_quad(Mesh& mesh, Surface surface, const vec3& corner_m, const vec3& edge_u_m,
              const vec3& edge_v_m);

/// The same with its own mapping: `top_left` of the texture window lies at corner + edge_v.
void add_card(Mesh& mesh, std::uint16_t material, const vec3& corner_m, const vec3& edge_u_m,
              const vec3& edge_v_m, vec2 top_left = {0.0F, 0.0F}, vec2 bottom_right = {1.0F, 1.0F});

enum Faces : unsigned {
    kLeft = 1,
    kRight = 2,
    kBottom = 4,
    kTop = 8,
    kBack = 16,
    kFront = 32,  // -x +x -y +y -z +z
    kSides = kLeft | kRight | kBack | kFront,
    kAllFaces = 63,
};
void add_box(Mesh& mesh, Surface surface, const vec3& min_m, const vec3& max_m,
             unsigned faces = kAllFaces);

/// Surface of revolution about the y axis through `centre_m`; the profile (radius, height) runs so
/// that its outside lies to the right of travel. Edges sharper than about 50 deg stay sharp.
void add_lathe(Mesh& mesh, Surface surface, std::span<const vec2> profile_m, int segments,
               const vec3& centre_m = vec3{0.0F});

/// Polygon in the x-y plane (counter-clockwise, convex), extruded from z0 to z1; sides and caps.
void add_prism(Mesh& mesh, Surface surface, std::span<const vec2> outline_m, float z0_m,
               float z1_m);

/// Sphere-like blob; `bumps` is the share by which noise moves the surface.
void add_blob(Mesh& mesh, Surface surface, const vec3& centre_m, const vec3& radii_m, int segments,
              float bumps = 0.0F, std::uint32_t seed = 0);

/// Texture position of a point on a wall that faces `normal`.
vec2 box_mapped(const vec3& position_m, const vec3& normal, float period_m);

}  // namespace foverig::builtin
