#include "renderer/scene/builtin/city_plan.h"
#include "renderer/scene/builtin/grid.h"
#include "renderer/scene/builtin/hash.h"
#include "renderer/scene/builtin/shapes.h"

namespace foverig::builtin::city {
namespace {

/// Outline of a car from above its length (x, nose at +): height of bonnet, cabin and boot.
struct Body {
    float length_m, width_m, sill_m, belt_m, roof_m, screen_m, rear_m;
};

/// Rounded lower body: a rounded rectangle in plan, drawn in towards sill and belt line.
void add_hull(Mesh& mesh, std::uint16_t paint, const Body& body) {
    const auto point = [&](float u, float v) {
        const float c = cosine(u);
        const float s = -sine(u);
        const float round = 1.0F / std::sqrt(std::sqrt(c * c * c * c + s * s * s * s));
        const float bulge = v < 0.15F ? 0.93F : v > 0.95F ? 0.0F : 1.0F - 0.22F * v * v * v * v;
        const float droop = 0.12F * c * c * c * c * (v > 0.5F ? 1.0F : 0.0F);
        return vec3{0.5F * body.length_m * c * round * (v > 0.95F ? 0.0F : mix(bulge, 1.0F, 0.6F)),
                    mix(body.sill_m, body.belt_m, v) - (v > 0.95F ? 0.0F : droop),
                    0.5F * body.width_m * s * round * bulge};
    };
    add_grid(mesh, paint, 24, 6, true, point, [](float u, float v) { return vec2{u, v}; });
}

/// Glazed cabin: a frustum whose top is the roof.
void add_cabin(Mesh& mesh, std::uint16_t paint, std::uint16_t glass, const Body& body) {
    const float half = 0.5F * body.width_m - 0.1F;
    const float top = half - 0.16F;
    const float y0 = body.belt_m - 0.08F;
    const float y1 = body.roof_m;
    const float front0 = body.screen_m;
    const float front1 = body.screen_m - 0.6F;
    const float rear0 = body.rear_m;
    const float rear1 = body.rear_m + 0.4F;
    const auto side = [&](std::uint16_t material, const vec3& a, const vec3& b, const vec3& c,
                          const vec3& d) {
        const vec3 normal = normalize(cross(b - a, d - a));
        const std::uint32_t first = mesh.add_vertex(a, normal, {0.0F, 1.0F});
        mesh.add_vertex(b, normal, {1.0F, 1.0F});
        mesh.add_vertex(c, normal, {1.0F, 0.0F});
        mesh.add_vertex(d, normal, {0.0F, 0.0F});
        mesh.add_triangle(first, first + 1, first + 2, material);
        mesh.add_triangle(first, first + 2, first + 3, material);
    };
    side(glass, {rear0, y0, half}, {front0, y0, half}, {front1, y1, top}, {rear1, y1, top});
    side(glass, {front0, y0, -half}, {rear0, y0, -half}, {rear1, y1, -top}, {front1, y1, -top});
    side(glass, {front0, y0, half}, {front0, y0, -half}, {front1, y1, -top}, {front1, y1, top});
    side(glass, {rear0, y0, -half}, {rear0, y0, half}, {rear1, y1, top}, {rear1, y1, -top});
    add_box(mesh, {paint, 1.0F}, {rear1 - 0.06F, y1 - 0.03F, -top - 0.02F},
            {front1 + 0.06F, y1 + 0.05F, top + 0.02F});
    for (const float z : {-1.0F, 1.0F}) {
        const float outer = z * half;
        const float inner = z * top;
        const float x = 0.5F * (front0 + rear0);
        const vec3 low{x - 0.05F, y0, outer + 0.012F * z};
        const vec3 high{x - 0.05F, y1, inner + 0.012F * z};
        const vec3 wide{0.1F, 0.0F, 0.0F};
        if (z > 0.0F)
            side(paint, low, low + wide, high + wide, high);
        else
            side(paint, low + wide, low, high, high + wide);
    }
}

void add_wheel(Mesh& mesh, const Paints& paints, const vec3& centre_m, float side) {
    Mesh upright;
    constexpr std::array<vec2, 3> kTyre{vec2{0.33F, -0.11F}, vec2{0.33F, 0.09F}, vec2{0.2F, 0.11F}};
    constexpr std::array<vec2, 2> kRim{vec2{0.2F, 0.11F}, vec2{0.0F, 0.08F}};
    add_lathe(upright, {paints.tyre, 1.0F}, kTyre, 12);
    add_lathe(upright, {paints.headlight, 1.0F}, kRim, 12);
    for (std::size_t i = 0; i < upright.positions_m.size(); ++i) {
        // Tips the lathe's axis from +y to +z or -z: a rotation about x, so nothing is mirrored.
        const auto tip = [&](const vec3& p) { return vec3{p.x, -side * p.z, side * p.y}; };
        upright.positions_m[i] = tip(upright.positions_m[i]);
        upright.normals[i] = tip(upright.normals[i]);
    }
    mesh.append(upright, {centre_m});
}

}  // namespace

Mesh make_car(const Paints& paints, std::uint32_t seed) {
    Mesh mesh;
    const bool van = hash(seed, 1U) % 5U == 0U;
    const Body body = van ? Body{4.9F, 1.95F, 0.28F, 1.15F, 2.05F, 1.75F, -2.3F}
                          : Body{4.3F, 1.78F, 0.24F, 0.92F, 1.43F, 1.05F, -1.55F};
    const std::uint16_t paint = paints.cars[hash(seed, 2U) % paints.cars.size()];
    add_hull(mesh, paint, body);
    add_cabin(mesh, paint, paints.glass[0], body);
    const float axle = 0.31F * body.length_m;
    const float track = 0.5F * body.width_m - 0.1F;
    for (const float x : {-axle, axle})
        for (const float side : {-1.0F, 1.0F})
            add_wheel(mesh, paints, {x, 0.33F, side * track}, side);
    const float nose = 0.5F * body.length_m;
    const float eye = body.sill_m + 0.34F;
    for (const float z : {-0.62F, 0.42F}) {
        add_box(mesh, {paints.headlight, 1.0F}, {nose - 0.3F, eye, z},
                {nose - 0.01F, eye + 0.12F, z + 0.2F});
        add_box(mesh, {paints.taillight, 1.0F}, {-nose + 0.01F, eye, z},
                {-nose + 0.3F, eye + 0.12F, z + 0.2F});
    }
    return mesh;
}

}  // namespace foverig::builtin::city
