#include <algorithm>

#include "renderer/scene/builtin/city_plan.h"
#include "renderer/scene/builtin/hash.h"
#include "renderer/scene/builtin/shapes.h"

namespace foverig::builtin::city {
namespace {

std::uint16_t pick_glass(const Paints& paints, const Look& look, int storey, int bay) {
    const std::uint32_t draw =
        hash(look.seed, static_cast<std::uint32_t>(storey), static_cast<std::uint32_t>(bay)) % 10U;
    return paints.glass[draw < 5U ? 0U : draw < 8U ? 1U : draw < 9U ? 2U : 3U];
}

Opening hole_of(Windows windows, const Opening& cell) {
    const float width = cell.x1 - cell.x0;
    const float height = cell.y1 - cell.y0;
    switch (windows) {
        case Windows::punched:
            return {cell.x0 + 0.27F * width, cell.x1 - 0.27F * width, cell.y0 + 0.9F,
                    cell.y1 - 0.55F};
        case Windows::tall:
            return {cell.x0 + 0.3F * width, cell.x1 - 0.3F * width, cell.y0 + 0.45F,
                    cell.y1 - 0.5F};
        case Windows::ribbon:
            return {cell.x0 + 0.06F, cell.x1 - 0.06F, cell.y0 + 1.0F, cell.y0 + 0.86F * height};
        case Windows::curtain:
            break;
    }
    return {cell.x0 + 0.05F, cell.x1 - 0.05F, cell.y0 + 0.5F, cell.y1 - 0.08F};
}

void add_storey(Mesh& mesh, const Paints& paints, const Look& look, int storey, int bays,
                float width_m) {
    const float bay_m = width_m / static_cast<float>(bays);
    const float low_m = Look::kGroundFloor_m + look.storey_m * static_cast<float>(storey);
    for (int i = 0; i < bays; ++i) {
        const float x0 = bay_m * static_cast<float>(i) - 0.5F * width_m;
        const Opening cell{x0, x0 + bay_m, low_m, low_m + look.storey_m};
        Opening hole = hole_of(look.windows, cell);
        const bool balcony =
            look.balconies && look.windows != Windows::curtain && i % 2 == 1 && i != bays - 1;
        if (balcony) hole.y0 = low_m + 0.12F;
        add_window(mesh, paints, look, cell, hole, pick_glass(paints, look, storey, i));
        if (balcony) add_balcony(mesh, paints, hole);
    }
}

void add_awning(Mesh& mesh, Surface surface, const Opening& hole) {
    const vec3 across{hole.x1 - hole.x0 + 0.3F, 0.0F, 0.0F};
    const vec3 low{hole.x0 - 0.15F, hole.y1 - 0.45F, 1.1F};
    const vec3 slope{0.0F, 0.55F, -1.1F};
    add_card(mesh, surface.material, low, across, slope, {0.0F, 0.05F}, {3.0F, 0.45F});
    add_card(mesh, surface.material, low - vec3{0.0F, 0.2F, 0.0F}, across, {0.0F, 0.2F, 0.0F},
             {0.0F, 0.05F}, {3.0F, 0.45F});
    add_card(mesh, surface.material, low + slope, across, -slope, {0.0F, 0.05F}, {3.0F, 0.45F});
}

void add_ground_floor(Mesh& mesh, const Paints& paints, const Look& look, int bays, float width_m) {
    const float bay_m = width_m / static_cast<float>(bays);
    const float top_m = Look::kGroundFloor_m;
    Look ground = look;
    ground.wall = look.shops ? look.trim : look.wall;
    for (int i = 0; i < bays; ++i) {
        const float x0 = bay_m * static_cast<float>(i) - 0.5F * width_m;
        const Opening cell{x0, x0 + bay_m, 0.0F, top_m};
        const bool door = i == bays / 2;
        Opening hole{x0 + 0.18F * bay_m, x0 + 0.82F * bay_m, look.shops ? 0.55F : 1.2F,
                     top_m - 1.1F};
        if (door) hole = {x0 + 0.26F * bay_m, x0 + 0.74F * bay_m, 0.1F, top_m - 1.2F};
        add_window(mesh, paints, ground, cell, hole, pick_glass(paints, look, 100, i));
        const std::uint32_t draw = hash(look.seed, 101U, static_cast<std::uint32_t>(i));
        if (look.shops && !door && draw % 3U != 0U) {
            add_awning(mesh, paints.awnings[hash(look.seed, 102U) % paints.awnings.size()], hole);
        }
    }
    const float half = 0.5F * width_m;
    add_box(mesh, look.trim, {-half, top_m - 0.3F, 0.0F}, {half, top_m, 0.16F},
            kTop | kBottom | kFront);
}

/// Bands, corner stones and the cornice that tie the windows together.
void add_trim(Mesh& mesh, const Look& look, float width_m) {
    const float half = 0.5F * width_m;
    const float top_m = look.height_m();
    constexpr unsigned kSeen = kAllFaces & ~kBack;
    if (look.windows == Windows::curtain) {
        add_box(mesh, look.trim, {-half, top_m, -0.3F}, {half, top_m + 1.2F, 0.05F});
        return;
    }
    for (int i = 2; i < look.storeys; i += 3) {
        const float y = Look::kGroundFloor_m + look.storey_m * static_cast<float>(i);
        add_box(mesh, look.trim, {-half, y - 0.08F, 0.0F}, {half, y + 0.1F, 0.07F},
                kTop | kBottom | kFront);
    }
    add_box(mesh, look.trim, {-half, top_m - 0.05F, -0.3F}, {half, top_m + 0.25F, 0.4F}, kAllFaces);
    add_box(mesh, look.wall, {-half, top_m + 0.25F, -0.3F}, {half, top_m + 0.9F, 0.0F},
            kAllFaces & ~kBottom);
    if (look.windows != Windows::tall) return;
    const int brackets = static_cast<int>(width_m / 0.9F);
    for (int i = 0; i < brackets; ++i) {
        const float x =
            width_m * ((static_cast<float>(i) + 0.5F) / static_cast<float>(brackets) - 0.5F);
        add_box(mesh, look.trim, {x - 0.1F, top_m - 0.35F, 0.0F}, {x + 0.1F, top_m - 0.05F, 0.3F},
                kSeen & ~kTop);
    }
    const int quoins = static_cast<int>((top_m - Look::kGroundFloor_m) / 0.8F);
    for (int i = 0; i < quoins; ++i) {
        const float y = Look::kGroundFloor_m + 0.8F * static_cast<float>(i) + 0.05F;
        const float size = i % 2 == 0 ? 0.55F : 0.35F;
        add_box(mesh, look.trim, {-half, y, 0.0F}, {-half + size, y + 0.7F, 0.05F}, kSeen & ~kLeft);
        add_box(mesh, look.trim, {half - size, y, 0.0F}, {half, y + 0.7F, 0.05F}, kSeen & ~kRight);
    }
}

}  // namespace

Mesh make_facade(const Paints& paints, const Look& look, float width_m) {
    Mesh mesh;
    const int bays = std::max(2, static_cast<int>(width_m / look.bay_m + 0.5F));
    add_ground_floor(mesh, paints, look, std::max(2, static_cast<int>(width_m / 3.6F + 0.5F)),
                     width_m);
    for (int storey = 0; storey < look.storeys; ++storey)
        add_storey(mesh, paints, look, storey, bays, width_m);
    add_trim(mesh, look, width_m);
    return mesh;
}

}  // namespace foverig::builtin::city
