#include "renderer/scene/builtin/grid.h"
#include "renderer/scene/builtin/painters.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/tunnel_path.h"

namespace foverig::builtin {
namespace {

using namespace tunnel;

constexpr int kPanelsAround = 4;
constexpr int kPanelsAlong = 12;
constexpr float kRadius_m = 2.3F;

/// Round-cornered square section.
vec3 wall_m(float around, float along_m) {
    const float c = cosine(around);
    const float s = sine(around);
    const float squareness = 1.0F / std::sqrt(std::sqrt(c * c * c * c + s * s * s * s));
    return axis_m(along_m) + vec3{c, s, 0.0F} * kRadius_m * mix(1.0F, squareness, 0.6F);
}

}  // namespace

Scene make_tunnel_maps(double detail) {
    SceneBuilder builder("tunnel-maps");
    const vec3 white{0.98F, 0.98F, 0.96F};
    const vec3 black{0.05F, 0.05F, 0.06F};
    const std::uint16_t checker = builder.add_textured(paint_checker(512, 8, white, black));
    const std::uint16_t noise = builder.add_textured(paint_noise(512, 8, 1.9F, 30));
    const std::uint16_t colours =
        builder.add_textured(paint_checker(512, 4, {0.93F, 0.72F, 0.12F}, {0.12F, 0.16F, 0.5F}));

    const int cells_around = kPanelsAround * finer(16, detail, 2);
    const int cells_along = kPanelsAlong * finer(8, detail, 2);
    Mesh mesh;
    add_grid(
        mesh, checker, cells_around, cells_along, true,
        [](float u, float v) { return wall_m(0.625F - u, kLength_m * (1.0F - v)); },
        [](float u, float v) {
            return vec2{u * kPanelsAround, v * kPanelsAlong};
        });
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const int cell = static_cast<int>(t / 2);
        const int around = cell % cells_around * kPanelsAround / cells_around;
        const int along = cell / cells_around * kPanelsAlong / cells_along;
        if ((around + along) % 2 != 0) mesh.materials[t] = noise;
        if ((around + along) % 2 == 0 && along % 3 == 2) mesh.materials[t] = colours;
    }
    builder.add_part(std::move(mesh));
    light_and_fly(builder.scene());
    return builder.finish();
}

}  // namespace foverig::builtin
