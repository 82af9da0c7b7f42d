#include <algorithm>

#include "renderer/scene/builtin/grid.h"
#include "renderer/scene/builtin/hash.h"
#include "renderer/scene/builtin/noise.h"
#include "renderer/scene/builtin/painters.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"
#include "renderer/scene/builtin/tunnel_path.h"

namespace foverig::builtin {
namespace {

using namespace tunnel;

constexpr float kRadius_m = 3.1F;
constexpr float kFloor_m = -1.55F;

/// Bare rock: boulders' bulges, ridges between them, and a rough skin.
float displacement_m(const vec3& p) {
    const float bulge = fractal_noise(p * 0.35F, 2, 21);
    const float ridge = 0.5F - std::fabs(fractal_noise(p * 0.8F + 7.5F, 3, 22));
    const float skin = fractal_noise(p * 3.1F, 3, 23);
    return 1.25F * bulge - 0.8F * ridge * ridge + 0.2F * skin;
}

vec3 wall_m(float around, float along_m) {
    const vec3 axis = axis_m(along_m);
    const vec3 out{cosine(around), sine(around), 0.0F};
    const vec3 smooth = axis + out * kRadius_m;
    vec3 p = axis + out * (kRadius_m + displacement_m(smooth));
    p.z += 0.25F * fractal_noise(smooth * 1.3F, 2, 24);
    const float floor_m =
        axis.y + kFloor_m + 0.16F * fractal_noise(vec3{p.x, 0.5F, p.z} * 1.2F, 4, 25);
    // The rock goes under the trodden floor with a soft edge.
    const float under = floor_m - p.y;
    const float round = 0.25F;
    if (under > -round)
        p.y = under > round ? floor_m : p.y + (under + round) * (under + round) / (4.0F * round);
    return p;
}

void scatter_boulders(Mesh& mesh, Surface rock, double detail) {
    Dice dice(26);
    for (int i = 0; i < 46; ++i) {
        const float along_m = dice.between(1.0F, kLength_m - 1.0F);
        const float side = dice.chance(0.5F) ? 1.0F : -1.0F;
        const float size = dice.between(0.12F, 0.5F);
        const vec3 foot =
            axis_m(along_m) + vec3{side * dice.between(1.35F, 2.3F), kFloor_m + 0.25F * size, 0.0F};
        const vec3 radii{size, size * dice.between(0.6F, 1.0F), size * dice.between(0.8F, 1.2F)};
        add_blob(mesh, rock, foot, radii, finer(20, detail, 6), 0.7F,
                 static_cast<std::uint32_t>(i));
    }
}

/// Six-sided glowing crystals in clusters along the foot of the walls.
void grow_crystals(Mesh& mesh, std::uint16_t first_material) {
    Dice dice(27);
    for (int i = 0; i < 14; ++i) {
        const float along_m = 2.0F + 3.2F * static_cast<float>(i);
        const float side = i % 2 == 0 ? 1.0F : -1.0F;
        const vec3 foot = axis_m(along_m) + vec3{side * 1.75F, kFloor_m - 0.1F, 0.0F};
        for (int k = 0; k < 5; ++k) {
            const float height = dice.between(0.35F, 0.95F);
            const float r = 0.11F * height + 0.03F;
            const vec2 profile[] = {{r * 0.8F, 0.0F}, {r, 0.75F * height}, {0.0F, height}};
            Mesh crystal;
            add_lathe(crystal, {static_cast<std::uint16_t>(first_material + i % 3)}, profile, 6);
            const float lean_x = dice.between(-0.5F, 0.3F) * side;
            const float lean_z = dice.between(-0.4F, 0.4F);
            for (vec3& p : crystal.positions_m) p += vec3{lean_x * p.y, 0.0F, lean_z * p.y};
            mesh.append(crystal, {foot + vec3{dice.between(-0.2F, 0.2F), 0.0F,
                                              dice.between(-0.25F, 0.25F)}});
        }
    }
}

}  // namespace

Scene make_tunnel_geom(double detail) {
    SceneBuilder builder("tunnel-geom");
    const Surface rock{builder.add_textured(paint_stone(512, {0.66F, 0.60F, 0.54F}, 20), 0.03F),
                       1.6F};
    const std::uint16_t crystal =
        builder.add_material({{0.2F, 0.5F, 0.6F}, vec3{0.2F}, 60.0F, {0.08F, 0.5F, 0.6F}});
    builder.add_material({{0.5F, 0.2F, 0.55F}, vec3{0.2F}, 60.0F, {0.45F, 0.1F, 0.5F}});
    builder.add_material({{0.6F, 0.5F, 0.15F}, vec3{0.2F}, 60.0F, {0.6F, 0.38F, 0.06F}});
    Mesh mesh;
    // u runs against the turn, so that the tube faces inwards.
    add_grid(
        mesh, rock.material, finer(168, detail, 16), finer(560, detail, 24), true,
        [](float u, float v) { return wall_m(0.75F - u, kLength_m * (1.0F - v)); },
        [&](float u, float v) {
            return vec2{11.0F * u, kLength_m * v / rock.period_m};
        });
    scatter_boulders(mesh, rock, detail);
    grow_crystals(mesh, crystal);
    builder.add_part(std::move(mesh));
    light_and_fly(builder.scene());
    return builder.finish();
}

}  // namespace foverig::builtin
