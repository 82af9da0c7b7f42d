#include "renderer/scene/builtin/hash.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"
#include "renderer/scene/builtin/voxel_houses.h"
#include "renderer/scene/builtin/voxel_land.h"
#include "renderer/scene/builtin/voxel_skins.h"

namespace foverig::builtin {
namespace {

using namespace voxel;

constexpr int kLot = (kBlockPitch - 2 * kStreetHalf) / 2;

/// What stands beside the blocks: thin posts and rails, cards of grass.
struct Props {
    std::uint16_t wood;
    Tufts tufts;
    Mesh solid;
    Mesh cut_out;
};

vec3 corner_of(int x, int y, int z) {
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

void fence(Grid& grid, Props& props, const Land& land, int x, int z, bool along_x) {
    const int top = land.ground(x, z);
    if (grid.at(x, top + 1, z) != Block::air) return;
    const vec3 foot = corner_of(x, top + 1, z);
    const Surface wood{props.wood, 1.0F};
    add_box(props.solid, wood, foot + vec3{0.4F, 0.0F, 0.4F}, foot + vec3{0.6F, 1.0F, 0.6F},
            kAllFaces & ~kBottom);
    for (const float y : {0.35F, 0.75F}) {
        const vec3 low = along_x ? vec3{0.0F, y, 0.45F} : vec3{0.45F, y, 0.0F};
        const vec3 high = along_x ? vec3{1.0F, y + 0.14F, 0.55F} : vec3{0.55F, y + 0.14F, 1.0F};
        add_box(props.solid, wood, foot + low, foot + high,
                along_x ? kBack | kFront | kTop | kBottom : kLeft | kRight | kTop | kBottom);
    }
}

void lay_garden(Grid& grid, Props& props, const Land& land, const Plot& plot, std::uint32_t seed) {
    for (int x = plot.x0; x <= plot.x1; ++x) {
        fence(grid, props, land, x, plot.z0, true);
        if (std::abs(2 * x - plot.x0 - plot.x1) > 3) fence(grid, props, land, x, plot.z1, true);
    }
    for (int z = plot.z0 + 1; z < plot.z1; ++z) {
        fence(grid, props, land, plot.x0, z, false);
        fence(grid, props, land, plot.x1, z, false);
    }
    for (std::uint32_t i = 0; i < 4; ++i) {
        const int x =
            plot.x0 + 3 + static_cast<int>(i % 2U) * 6 + static_cast<int>(hash(seed, i) % 3U);
        const int z =
            plot.z0 + 3 + static_cast<int>(i / 2U) * 6 + static_cast<int>(hash(seed, i + 9U) % 3U);
        plant_tree(grid, x, land.ground(x, z), z, hash(seed, i, 7U));
    }
}

void build_lot(Grid& grid, Props& props, const Land& land, int x0, int z0) {
    const int middle_x = x0 + kLot / 2;
    const int middle_z = z0 + kLot / 2;
    const Plot lot{x0 + 1, z0 + 1, x0 + kLot - 2, z0 + kLot - 2, land.ground(middle_x, middle_z)};
    for (const int x : {x0, x0 + kLot}) {
        for (const int z : {z0, z0 + kLot}) {
            if (!land.in_town(x, z) || land.ground(x, z) <= kWaterLevel + 1) return;
        }
    }
    const std::uint32_t seed =
        hash(static_cast<std::uint32_t>(x0), static_cast<std::uint32_t>(z0), 45U);
    const std::uint32_t kind = seed % 20U;
    if (kind < 2U) return build_market(grid, lot, seed);
    if (kind < 5U) return lay_garden(grid, props, land, lot, seed);
    if (kind == 5U) {
        const int height = 16 + 4 * static_cast<int>(hash(seed, 1U) % 3U);
        return build_tower(grid,
                           {middle_x - 4, middle_z - 4, middle_x + 4, middle_z + 4, lot.ground},
                           height, hash(seed, 2U) % 2U == 0U);
    }
    const int spare_x = static_cast<int>(hash(seed, 3U) % 5U);
    const int spare_z = static_cast<int>(hash(seed, 4U) % 5U);
    const int left = spare_x == 0 ? 0 : static_cast<int>(hash(seed, 5U)) & 1;
    build_house(grid,
                {lot.x0 + left, lot.z0, lot.x1 - spare_x + left, lot.z1 - spare_z, lot.ground},
                hash(seed, 6U));
}

void build_town(Grid& grid, Props& props, const Land& land) {
    const int blocks = land.town_radius / kBlockPitch + 1;
    for (int bz = -blocks; bz <= blocks; ++bz) {
        for (int bx = -blocks; bx <= blocks; ++bx) {
            const int x0 = bx * kBlockPitch + kStreetHalf;
            const int z0 = bz * kBlockPitch + kStreetHalf;
            if (bx == 0 && bz == -1) {
                build_church(grid,
                             {x0 + 8, z0 + 2, x0 + 24, z0 + 31, land.ground(x0 + 16, z0 + 16)});
                continue;
            }
            for (int i = 0; i < 4; ++i)
                build_lot(grid, props, land, x0 + i % 2 * kLot, z0 + i / 2 * kLot);
        }
    }
}

void build_town_wall(Grid& grid, const Land& land) {
    const auto inner = static_cast<float>(land.town_radius);
    for (int z = -land.town_radius - 4; z <= land.town_radius + 4; ++z) {
        for (int x = -land.town_radius - 4; x <= land.town_radius + 4; ++x) {
            const float from_middle =
                length(vec2{static_cast<float>(x), static_cast<float>(z)}) - inner;
            if (from_middle < 0.0F || from_middle >= 3.0F) continue;
            const int top = land.ground(x, z);
            if (top <= kWaterLevel) continue;
            const bool gate = wrapped(x + kStreetHalf, kBlockPitch) < 2 * kStreetHalf ||
                              wrapped(z + kStreetHalf, kBlockPitch) < 2 * kStreetHalf;
            const bool parapet = from_middle >= 2.0F && wrapped(x + z, 3) != 0;
            grid.fill(x, top + (gate ? 6 : 0), z, x, top + (parapet ? 10 : 8), z,
                      gate ? Block::stone : Block::ashlar);
        }
    }
}

void light_streets(Grid& grid, Props& props, const Land& land) {
    const int reach = land.town_radius;
    for (int z = -reach; z <= reach; ++z) {
        for (int x = -reach; x <= reach; ++x) {
            const bool beside_x = wrapped(x - kStreetHalf, kBlockPitch) == 0 && wrapped(z, 10) == 5;
            const bool beside_z = wrapped(z - kStreetHalf, kBlockPitch) == 0 && wrapped(x, 10) == 5;
            if ((!beside_x && !beside_z) || !land.in_town(x, z) || land.in_street(x, z)) continue;
            const int top = land.ground(x, z);
            if (top <= kWaterLevel + 1 || grid.at(x, top + 1, z) != Block::air ||
                grid.at(x, top + 5, z) != Block::air)
                continue;
            const vec3 foot = corner_of(x, top + 1, z);
            add_box(props.solid, {props.wood, 1.0F}, foot + vec3{0.38F, 0.0F, 0.38F},
                    foot + vec3{0.62F, 3.0F, 0.62F}, kSides);
            grid.set(x, top + 4, z, Block::lamp);
        }
    }
}

void grow_tufts(const Grid& grid, Props& props, const Land& land) {
    const int half = grid.half();
    for (int z = -half; z < grid.side() - half; ++z) {
        for (int x = -half; x < grid.side() - half; ++x) {
            const std::uint32_t seed =
                hash(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(z), 46U);
            if (seed % 24U != 0U) continue;
            const int top = land.ground(x, z);
            if (grid.at(x, top, z) != Block::grass || grid.at(x, top + 1, z) != Block::air)
                continue;
            const std::uint32_t kind = hash(seed) % 8U;
            const std::uint16_t material = kind == 0U   ? props.tufts.red
                                           : kind == 1U ? props.tufts.yellow
                                                        : props.tufts.grass;
            const vec3 foot = corner_of(x, top + 1, z);
            const vec3 up{0.0F, 0.85F, 0.0F};
            add_card(props.cut_out, material, foot + vec3{0.15F, 0.0F, 0.15F}, {0.7F, 0.0F, 0.7F},
                     up);
            add_card(props.cut_out, material, foot + vec3{0.15F, 0.0F, 0.85F}, {0.7F, 0.0F, -0.7F},
                     up);
        }
    }
}

void light_and_fly(Scene& scene, const Land& land, int side) {
    const float far_m = 0.45F * static_cast<float>(side);
    const vec3 sun{0.5F * far_m, far_m, 0.62F * far_m};
    const vec3 colour{1.0F, 0.93F, 0.8F};
    // The same irradiance in the town's middle whatever the size of the world.
    const float strength = 3.4F * dot(sun, sun);
    scene.point_lights.push_back({sun, colour * strength});
    const float edge_m = 0.16F * far_m;
    const vec3 across{edge_m, 0.0F, 0.0F};
    const vec3 along = normalize(cross(across, sun)) * edge_m;
    scene.area_lights.push_back(
        {sun - 0.5F * (across + along), across, along, colour * (strength / (edge_m * edge_m))});
    scene.ambient = vec3{0.34F, 0.38F, 0.46F};
    scene.background = vec3{0.46F, 0.66F, 0.95F};
    const auto over = [&](float x, float z, float up_m) {
        const int ground =
            land.ground(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(z)));
        return vec3{x, static_cast<float>(ground) + 1.0F + up_m, z};
    };
    scene.camera_path = {{over(-0.5F, 44.0F, 2.2F), over(0.0F, 10.0F, 3.5F)},
                         {over(-0.5F, 24.0F, 2.4F), over(6.0F, -6.0F, 5.0F)},
                         {over(-0.5F, 3.0F, 3.0F), over(22.0F, -12.0F, 7.0F)},
                         {over(-4.0F, -1.0F, 9.0F), over(20.0F, -16.0F, 10.0F)},
                         {over(-14.0F, -2.0F, 28.0F), over(20.0F, -20.0F, 12.0F)},
                         {over(-34.0F, 6.0F, 36.0F), over(12.0F, 2.0F, 10.0F)},
                         {over(-42.0F, 36.0F, 30.0F), over(0.0F, 10.0F, 8.0F)},
                         {over(-20.0F, 66.0F, 26.0F), over(10.0F, 0.0F, 6.0F)}};
    scene.camera_path_s = 24.0F;
}

}  // namespace

Scene make_voxel_town(double detail) {
    const int side = finer(242, detail, 96);
    const Land land{side * 36 / 100};
    SceneBuilder builder("voxel-town");
    const Skins skins = add_skins(builder);
    Props props{skins[static_cast<std::size_t>(Block::log)].side, add_tufts(builder), {}, {}};
    {
        Grid grid(side, kWorldHeight);
        lay_land(grid, land);
        grow_forest(grid, land);
        build_town(grid, props, land);
        build_town_wall(grid, land);
        light_streets(grid, props, land);
        grow_tufts(grid, props, land);
        builder.add_part(mesh_blocks(grid, skins, false));
        Mesh cut_outs = mesh_blocks(grid, skins, true);
        cut_outs.append(props.cut_out);
        builder.add_part(std::move(props.solid));
        builder.add_part(std::move(cut_outs), true);
    }
    light_and_fly(builder.scene(), land, side);
    return builder.finish();
}

}  // namespace foverig::builtin
