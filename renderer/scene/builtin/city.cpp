#include "renderer/scene/builtin/city_plan.h"
#include "renderer/scene/builtin/foliage.h"
#include "renderer/scene/builtin/hash.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"

namespace foverig::builtin {
namespace {

using namespace city;

constexpr float kBlockX_m = kPitchX_m - kStreet_m;
constexpr float kBlockZ_m = kPitchZ_m - kStreet_m;
constexpr int kLotsX = 3;
constexpr int kLotsZ = 2;

struct City {
    const Paints& paints;
    Mesh solid;
    Mesh cut_out;
};

void plant_tree(City& city, const vec3& foot_m, float height_m, std::uint32_t seed) {
    const std::array<vec2, 4> trunk{vec2{0.2F, 0.0F}, vec2{0.13F, 0.3F},
                                    vec2{0.1F, 0.6F * height_m}, vec2{0.03F, 0.85F * height_m}};
    add_lathe(city.solid, city.paints.bark, trunk, 8, foot_m);
    const float radius_m = 0.42F * height_m;
    city.cut_out.append(make_crown(city.paints.foliage, radius_m, 54, seed),
                        {foot_m + vec3{0.0F, height_m - 0.8F * radius_m, 0.0F}});
}

/// Sidewalk around a block with lamps, trees and parked cars along its kerb.
void furnish_kerb(City& city, const vec3& centre_m, std::uint32_t seed) {
    const Mesh lamp = make_street_lamp(city.paints);
    for (unsigned k = 0; k < 4; ++k) {
        const float turns = 0.25F * static_cast<float>(k);
        const float along_m = k % 2 == 0 ? kBlockX_m : kBlockZ_m;
        const float kerb_m = 0.5F * (k % 2 == 0 ? kBlockZ_m : kBlockX_m);
        const auto at = [&](float along, float out, float up) {
            return centre_m + rotate_y({along, up, kerb_m + out}, turns);
        };
        for (const float share : {-0.3F, 0.25F})
            city.solid.append(lamp, {at(share * along_m, -0.5F, kKerb_m), turns});
        for (int i = 0; i < 4; ++i) {
            const float share = (static_cast<float>(i) + 0.5F) / 4.0F - 0.5F;
            const std::uint32_t draw = hash(seed, k, static_cast<std::uint32_t>(i));
            if (draw % 4U != 0U)
                plant_tree(city, at(share * along_m, -0.8F, kKerb_m),
                           5.0F + 2.0F * unit_of(hash(draw)), draw);
        }
        const int places = static_cast<int>((along_m - 16.0F) / 6.0F);
        for (int i = 0; i < places; ++i) {
            const std::uint32_t draw = hash(seed, k, 50U + static_cast<std::uint32_t>(i));
            if (draw % 5U < 2U) continue;
            const float along =
                6.0F * (static_cast<float>(i) - 0.5F * static_cast<float>(places - 1));
            // Facing with the traffic of that side of the street.
            city.solid.append(make_car(city.paints, draw), {at(along, 1.15F, 0.0F), turns});
        }
        if (hash(seed, k, 90U) % 2U == 0U) {
            const float along = (unit_of(hash(seed, k, 91U)) - 0.5F) * along_m;
            city.solid.append(make_car(city.paints, hash(seed, k, 92U)),
                              {at(along, 3.6F, 0.0F), turns});
        }
    }
}

void lay_park(City& city, const vec3& centre_m, std::uint32_t seed) {
    const float half_x = 0.5F * kBlockX_m - kSidewalk_m;
    const float half_z = 0.5F * kBlockZ_m - kSidewalk_m;
    const vec3 low = centre_m + vec3{-half_x, 0.0F, -half_z};
    add_box(city.solid, city.paints.grass, low, centre_m + vec3{half_x, kKerb_m + 0.08F, half_z},
            kSides | kTop);
    const auto path = [&](float size_x, float size_z) {
        const vec3 half{0.5F * size_x, 0.0F, 0.5F * size_z};
        add_box(city.solid, city.paints.sidewalk, centre_m - half,
                centre_m + half + vec3{0.0F, kKerb_m + 0.1F, 0.0F}, kSides | kTop);
    };
    path(2.0F * half_x + 0.1F, 3.0F);
    path(3.0F, 2.0F * half_z + 0.1F);
    constexpr std::array<vec2, 9> kFountain{vec2{4.0F, 0.0F}, vec2{4.0F, 0.7F}, vec2{3.6F, 0.7F},
                                            vec2{3.6F, 0.5F}, vec2{0.6F, 0.5F}, vec2{0.4F, 1.6F},
                                            vec2{1.4F, 2.1F}, vec2{1.3F, 2.2F}, vec2{0.0F, 2.0F}};
    add_lathe(city.solid, city.paints.trim, kFountain, 40, centre_m + vec3{0.0F, kKerb_m, 0.0F});
    constexpr std::array<vec2, 2> kPool{vec2{3.7F, 0.55F}, vec2{0.0F, 0.55F}};
    add_lathe(city.solid, {city.paints.water}, kPool, 40, centre_m + vec3{0.0F, kKerb_m, 0.0F});
    Dice dice(seed);
    for (int i = 0; i < 26; ++i) {
        const float x = dice.between(3.0F, half_x - 2.0F) * (i % 2 == 0 ? 1.0F : -1.0F);
        const float z = dice.between(3.0F, half_z - 2.0F) * (i % 4 < 2 ? 1.0F : -1.0F);
        if (length(vec2{x, z}) < 7.0F) continue;
        plant_tree(city, centre_m + vec3{x, kKerb_m, z}, dice.between(6.0F, 9.5F),
                   hash(seed, static_cast<std::uint32_t>(i)));
    }
    const Mesh bench = make_bench(city.paints);
    for (unsigned i = 0; i < 8; ++i) {
        const float turns = 0.125F * static_cast<float>(i) + 0.0625F;
        city.solid.append(bench, {centre_m + vec3{0.0F, kKerb_m + 0.1F, 0.0F} +
                                      rotate_y({0.0F, 0.0F, 5.2F}, turns),
                                  turns + 0.5F});
    }
}

/// Storeys fall off from the middle of the city, with a wide spread.
int draw_storeys(const vec3& centre_m, std::uint32_t seed) {
    const float middle = 1.0F - smoothstep(20.0F, 190.0F, length(centre_m));
    const float draw = unit_of(hash(seed, 11U));
    return 2 + static_cast<int>(3.0F * unit_of(hash(seed, 12U)) + 3.0F * middle +
                                (draw > 0.88F ? 7.0F : 2.0F) * middle);
}

void build_block(City& city, const vec3& centre_m, std::uint32_t seed) {
    const vec3 ground = centre_m + vec3{0.0F, kKerb_m, 0.0F};
    if (hash(seed, 20U) % 9U == 0U) {
        const Look tower =
            make_look(city.paints, 16 + static_cast<int>(hash(seed, 21U) % 10U), seed);
        add_building(city.solid, city.paints, tower, ground, {24.0F, 22.0F}, 15U);
        for (const float x : {-19.0F, 19.0F}) {
            for (const float z : {-13.0F, 0.0F, 13.0F})
                plant_tree(city, ground + vec3{x, 0.0F, z}, 6.5F,
                           hash(seed, static_cast<std::uint32_t>(z + 99.0F)));
        }
        return;
    }
    const vec2 inner{kBlockX_m - 2.0F * kSidewalk_m, kBlockZ_m - 2.0F * kSidewalk_m};
    const vec2 lot{inner.x / kLotsX, inner.y / kLotsZ};
    for (int i = 0; i < kLotsX; ++i) {
        for (int j = 0; j < kLotsZ; ++j) {
            const std::uint32_t lot_seed =
                hash(seed, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
            const vec3 centre = ground + vec3{lot.x * (static_cast<float>(i) - 1.0F), 0.0F,
                                              lot.y * (static_cast<float>(j) - 0.5F)};
            const unsigned sides = (j == 1 ? 1U : 4U) | (i == 2 ? 2U : 0U) | (i == 0 ? 8U : 0U);
            add_building(city.solid, city.paints,
                         make_look(city.paints, draw_storeys(centre, lot_seed), lot_seed), centre,
                         lot, sides);
        }
    }
}

void light_and_fly(Scene& scene) {
    const vec3 sun{190.0F, 320.0F, 250.0F};
    const vec3 colour{1.0F, 0.94F, 0.84F};
    const float strength = 3.4F * dot(sun, sun);
    scene.point_lights.push_back({sun, colour * strength});
    constexpr float kEdge_m = 50.0F;
    const vec3 across = normalize(cross({0.0F, 1.0F, 0.0F}, sun)) * kEdge_m;
    const vec3 along = normalize(cross(across, sun)) * kEdge_m;
    scene.area_lights.push_back(
        {sun - 0.5F * (across + along), across, along, colour * (strength / (kEdge_m * kEdge_m))});
    scene.ambient = vec3{0.34F, 0.37F, 0.43F};
    scene.background = vec3{0.48F, 0.66F, 0.92F};
    const float street_m = 0.5F * kPitchX_m;
    scene.camera_path = {{{street_m, 2.0F, 78.0F}, {street_m, 4.0F, 40.0F}},
                         {{street_m, 2.4F, 48.0F}, {street_m - 4.0F, 6.0F, 10.0F}},
                         {{street_m, 3.4F, 28.0F}, {10.0F, 9.0F, 6.0F}},
                         {{street_m - 3.0F, 9.0F, 12.0F}, {0.0F, 10.0F, 0.0F}},
                         {{street_m - 14.0F, 22.0F, 2.0F}, {-20.0F, 10.0F, -16.0F}},
                         {{0.0F, 38.0F, 8.0F}, {-60.0F, 12.0F, -34.0F}},
                         {{-24.0F, 47.0F, 16.0F}, {10.0F, 14.0F, -40.0F}},
                         {{-street_m, 52.0F, 46.0F}, {4.0F, 10.0F, 0.0F}},
                         {{-street_m, 46.0F, 84.0F}, {0.0F, 8.0F, -6.0F}}};
    scene.camera_path_s = 24.0F;
}

}  // namespace

Scene make_city(double detail) {
    SceneBuilder builder("city");
    const Paints paints = add_paints(builder);
    City city{paints, {}, {}};
    const int blocks = finer(5, detail, 3);
    lay_streets(city.solid, paints, blocks, blocks);
    const int half = blocks / 2;
    for (int i = -half; i < blocks - half; ++i) {
        for (int j = -half; j < blocks - half; ++j) {
            const vec3 centre{kPitchX_m * static_cast<float>(i), 0.0F,
                              kPitchZ_m * static_cast<float>(j)};
            const std::uint32_t seed =
                hash(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), 70U);
            const vec3 corner{0.5F * kBlockX_m, 0.0F, 0.5F * kBlockZ_m};
            add_box(city.solid, paints.sidewalk, centre - corner,
                    centre + corner + vec3{0.0F, kKerb_m, 0.0F}, kSides | kTop);
            furnish_kerb(city, centre, seed);
            if (i == 0 && j == 0) {
                lay_park(city, centre, seed);
            } else {
                build_block(city, centre, seed);
            }
        }
    }
    builder.add_part(std::move(city.solid));
    builder.add_part(std::move(city.cut_out), true);
    light_and_fly(builder.scene());
    return builder.finish();
}

}  // namespace foverig::builtin
