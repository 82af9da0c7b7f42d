#include "renderer/scene/builtin/city_plan.h"
#include "renderer/scene/builtin/shapes.h"

namespace foverig::builtin::city {
namespace {

void add_panel(Mesh& mesh, Surface surface, float x0, float x1, float y0, float y1, float z) {
    if (x1 - x0 < 0.001F || y1 - y0 < 0.001F) return;
    add_quad(mesh, surface, {x0, y0, z}, {x1 - x0, 0.0F, 0.0F}, {0.0F, y1 - y0, 0.0F});
}

}  // namespace

void add_window(Mesh& mesh, const Paints& paints, const Look& look, const Opening& cell,
                const Opening& hole, std::uint16_t glass) {
    add_panel(mesh, look.wall, cell.x0, hole.x0, cell.y0, cell.y1, 0.0F);
    add_panel(mesh, look.wall, hole.x1, cell.x1, cell.y0, cell.y1, 0.0F);
    add_panel(mesh, look.wall, hole.x0, hole.x1, cell.y0, hole.y0, 0.0F);
    add_panel(mesh, look.wall, hole.x0, hole.x1, hole.y1, cell.y1, 0.0F);

    constexpr float kDepth_m = 0.22F;
    const vec3 in{0.0F, 0.0F, -kDepth_m};
    const vec3 across{hole.x1 - hole.x0, 0.0F, 0.0F};
    const vec3 up{0.0F, hole.y1 - hole.y0, 0.0F};
    const vec3 low{hole.x0, hole.y0, 0.0F};
    add_quad(mesh, look.trim, low, in, up);
    add_quad(mesh, look.trim, low + across + in, -in, up);
    add_quad(mesh, look.trim, low + up + in, across, -in);
    add_panel(mesh, {glass, 1.0F}, hole.x0, hole.x1, hole.y0, hole.y1, -kDepth_m);

    constexpr float kBar_m = 0.035F;
    const float front = -kDepth_m + 0.05F;
    const float middle = 0.5F * (hole.x0 + hole.x1);
    const Surface frame = look.windows == Windows::curtain ? paints.metal : paints.paint_white;
    add_box(mesh, frame, {middle - kBar_m, hole.y0, -kDepth_m}, {middle + kBar_m, hole.y1, front},
            kLeft | kRight | kFront);
    if (look.windows == Windows::curtain) return;
    const float transom = hole.y0 + 0.68F * up.y;
    add_box(mesh, frame, {hole.x0, transom - kBar_m, -kDepth_m},
            {hole.x1, transom + kBar_m, front - 0.01F}, kTop | kBottom | kFront);
    add_box(mesh, look.trim, {hole.x0 - 0.08F, hole.y0 - 0.1F, -kDepth_m},
            {hole.x1 + 0.08F, hole.y0, 0.1F}, kAllFaces & ~kBack);
    if (look.windows == Windows::tall) {
        add_box(mesh, look.trim, {hole.x0 - 0.16F, hole.y1, -0.02F},
                {hole.x1 + 0.16F, hole.y1 + 0.2F, 0.1F}, kAllFaces & ~kBack);
        add_box(mesh, look.trim, {hole.x0 - 0.12F, hole.y0, -0.02F}, {hole.x0, hole.y1, 0.05F},
                kLeft | kRight | kFront);
        add_box(mesh, look.trim, {hole.x1, hole.y0, -0.02F}, {hole.x1 + 0.12F, hole.y1, 0.05F},
                kLeft | kRight | kFront);
    }
}

void add_balcony(Mesh& mesh, const Paints& paints, const Opening& hole) {
    constexpr float kOut_m = 1.1F;
    const float x0 = hole.x0 - 0.35F;
    const float x1 = hole.x1 + 0.35F;
    const float floor_m = hole.y0 - 0.02F;
    add_box(mesh, paints.concrete, {x0, floor_m - 0.16F, 0.0F}, {x1, floor_m, kOut_m},
            kAllFaces & ~kBack);
    const float rail_m = floor_m + 1.0F;
    const auto rail = [&](const vec3& low, const vec3& high) {
        add_box(mesh, paints.metal, low, high);
    };
    rail({x0, rail_m, kOut_m - 0.06F}, {x1, rail_m + 0.05F, kOut_m});
    rail({x0, rail_m, 0.0F}, {x0 + 0.05F, rail_m + 0.05F, kOut_m - 0.06F});
    rail({x1 - 0.05F, rail_m, 0.0F}, {x1, rail_m + 0.05F, kOut_m - 0.06F});
    const auto post = [&](float x, float z) {
        add_box(mesh, paints.metal, {x, floor_m, z}, {x + 0.03F, rail_m, z + 0.03F}, kSides);
    };
    constexpr int kPosts = 7;
    for (int i = 0; i < kPosts; ++i)
        post(mix(x0, x1 - 0.03F, static_cast<float>(i) / (kPosts - 1)), kOut_m - 0.045F);
    for (int i = 0; i < 2; ++i) {
        const float z = 0.2F + 0.36F * static_cast<float>(i);
        post(x0, z);
        post(x1 - 0.03F, z);
    }
}

}  // namespace foverig::builtin::city
