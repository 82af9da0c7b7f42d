#include "renderer/scene/builtin/city_plan.h"
#include "renderer/scene/builtin/hash.h"
#include "renderer/scene/builtin/painters.h"

namespace foverig::builtin::city {
namespace {

std::uint16_t add_glossy(SceneBuilder& builder, const vec3& colour, float specular,
                         float reflectance) {
    Material m;
    m.diffuse = colour;
    m.specular = vec3{specular};
    m.shininess = 60.0F;
    m.reflectance = reflectance;
    return builder.add_material(m);
}

Canvas paint_asphalt(std::uint32_t size_px) {
    return paint_stone(size_px, {0.33F, 0.33F, 0.34F}, 61);
}

Canvas paint_awning(const vec3& stripe) {
    return paint_checker(64, 2, stripe, {0.93F, 0.92F, 0.88F});
}

}  // namespace

Paints add_paints(SceneBuilder& builder) {
    Paints p{};
    const auto brick = [&](const vec3& stone, std::uint32_t seed) {
        const Masonry masonry{8, 24, 0.14F, 0.09F, stone, {0.70F, 0.67F, 0.62F}};
        return Surface{builder.add_textured(paint_masonry(512, masonry, seed)), 2.4F};
    };
    const auto plaster = [&](const vec3& colour, std::uint32_t seed) {
        return Surface{builder.add_textured(paint_plaster(256, colour, seed)), 5.0F};
    };
    const Masonry blocks{3, 6, 0.04F, 0.05F, {0.73F, 0.70F, 0.64F}, {0.50F, 0.48F, 0.45F}};
    p.walls = {brick({0.56F, 0.30F, 0.22F}, 51),
               brick({0.66F, 0.52F, 0.38F}, 52),
               plaster({0.86F, 0.79F, 0.64F}, 53),
               plaster({0.72F, 0.76F, 0.78F}, 54),
               plaster({0.84F, 0.66F, 0.52F}, 55),
               plaster({0.68F, 0.74F, 0.62F}, 56),
               Surface{builder.add_textured(paint_masonry(256, blocks, 57)), 3.0F}};
    p.trim = {builder.add_textured(paint_stone(256, {0.83F, 0.80F, 0.74F}, 58)), 2.0F};
    p.dark_trim = {builder.add_textured(paint_stone(128, {0.36F, 0.35F, 0.35F}, 59)), 2.0F};
    p.concrete = {builder.add_textured(paint_plaster(256, {0.66F, 0.65F, 0.63F}, 60)), 4.0F};
    p.asphalt = {builder.add_textured(paint_asphalt(256)), 4.0F};
    const Masonry slabs{4, 4, 0.05F, 0.06F, {0.62F, 0.60F, 0.58F}, {0.44F, 0.43F, 0.42F}, true};
    p.sidewalk = {builder.add_textured(paint_masonry(256, slabs, 62)), 3.0F};
    p.roof = {builder.add_textured(paint_stone(128, {0.47F, 0.46F, 0.45F}, 63)), 4.0F};
    p.grass = {builder.add_textured(paint_noise(256, 32, 0.5F, 64)), 3.0F};
    builder.scene().materials[p.grass.material].diffuse = {0.30F, 0.55F, 0.14F};
    p.metal = {add_glossy(builder, vec3{0.12F, 0.13F, 0.14F}, 0.12F, 0.0F), 1.0F};
    p.paint_white = {builder.add_matte(vec3{0.72F}), 1.0F};
    p.wood = {builder.add_textured(paint_planks(128, {0.48F, 0.33F, 0.2F}, 4, 65)), 1.0F};
    p.bark = {builder.add_textured(paint_bark(128, {0.36F, 0.28F, 0.2F}, 66)), 1.0F};
    p.glass = {add_glossy(builder, {0.035F, 0.05F, 0.065F}, 0.3F, 0.3F),
               add_glossy(builder, {0.06F, 0.09F, 0.11F}, 0.3F, 0.3F),
               add_glossy(builder, {0.22F, 0.20F, 0.17F}, 0.2F, 0.2F),
               add_glossy(builder, {0.40F, 0.37F, 0.31F}, 0.15F, 0.15F)};
    p.cars = {add_glossy(builder, {0.55F, 0.03F, 0.03F}, 0.25F, 0.15F),
              add_glossy(builder, {0.05F, 0.12F, 0.38F}, 0.25F, 0.15F),
              add_glossy(builder, vec3{0.62F}, 0.25F, 0.15F),
              add_glossy(builder, vec3{0.03F}, 0.25F, 0.15F),
              add_glossy(builder, {0.30F, 0.32F, 0.34F}, 0.25F, 0.15F),
              add_glossy(builder, {0.72F, 0.48F, 0.04F}, 0.25F, 0.15F)};
    const std::array<vec3, 5> stripes{vec3{0.68F, 0.15F, 0.14F}, vec3{0.14F, 0.38F, 0.24F},
                                      vec3{0.15F, 0.25F, 0.5F}, vec3{0.75F, 0.5F, 0.15F},
                                      vec3{0.45F, 0.2F, 0.35F}};
    for (std::size_t i = 0; i < stripes.size(); ++i)
        p.awnings[i] = {builder.add_textured(paint_awning(stripes[i])), 1.0F};
    Material water;
    water.diffuse = {0.07F, 0.17F, 0.2F};
    water.specular = vec3{0.25F};
    water.shininess = 60.0F;
    water.reflectance = 0.3F;
    p.water = builder.add_material(water);
    p.tyre = builder.add_matte(vec3{0.02F});
    p.headlight = builder.add_matte(vec3{0.85F});
    p.taillight = builder.add_matte({0.5F, 0.01F, 0.01F});
    p.lamp = builder.add_glowing({1.1F, 1.0F, 0.8F});
    p.foliage = builder.add_cut_out(paint_foliage(256, {0.30F, 0.48F, 0.18F}, 150, 67));
    return p;
}

Look make_look(const Paints& paints, int storeys, std::uint32_t seed) {
    Look look;
    look.seed = seed;
    look.storeys = storeys;
    look.wall = paints.walls[hash(seed, 1U) % paints.walls.size()];
    look.trim = hash(seed, 2U) % 3U == 0U ? paints.dark_trim : paints.trim;
    look.bay_m = 2.8F + 0.9F * unit_of(hash(seed, 3U));
    look.storey_m = 3.0F + 0.5F * unit_of(hash(seed, 4U));
    look.shops = hash(seed, 5U) % 4U != 0U;
    look.balconies = hash(seed, 6U) % 4U == 0U;
    const std::uint32_t kind = hash(seed, 7U) % 10U;
    look.windows = kind < 5U ? Windows::punched : kind < 8U ? Windows::tall : Windows::ribbon;
    if (storeys > 13) {
        look.windows = Windows::curtain;
        look.bay_m = 2.4F;
        look.trim = paints.dark_trim;
        look.wall = paints.concrete;
    }
    if (look.windows == Windows::ribbon)
        look.wall = hash(seed, 8U) % 2U == 0U ? paints.concrete : look.wall;
    return look;
}

}  // namespace foverig::builtin::city
