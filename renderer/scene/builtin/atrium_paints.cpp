#include "renderer/scene/builtin/atrium_plan.h"
#include "renderer/scene/builtin/painters.h"

namespace foverig::builtin::atrium {

Paints add_paints(SceneBuilder& builder) {
    Paints p{};
    p.stone = {builder.add_textured(paint_stone(512, {0.74F, 0.67F, 0.56F}, 1), 0.02F), 1.4F};
    p.pale_stone = {builder.add_textured(paint_stone(512, {0.86F, 0.83F, 0.76F}, 2), 0.03F), 1.4F};
    const Masonry brick{6, 14, 0.12F, 0.10F, {0.62F, 0.37F, 0.27F}, {0.72F, 0.67F, 0.6F}};
    p.brick = {builder.add_textured(paint_masonry(512, brick, 3)), 1.4F};
    p.plaster = {builder.add_textured(paint_plaster(512, {0.85F, 0.74F, 0.57F}, 4)), 2.8F};
    p.vault = {builder.add_textured(paint_plaster(256, {0.82F, 0.79F, 0.73F}, 5)), 2.8F};
    const Masonry slabs{4, 4, 0.03F, 0.05F, {0.62F, 0.58F, 0.53F}, {0.32F, 0.3F, 0.28F}, false};
    p.floor = {builder.add_textured(paint_masonry(512, slabs, 6), 0.04F), 2.8F};
    p.inlay = {builder.add_textured(paint_inlay(512, {0.84F, 0.80F, 0.73F}, {0.30F, 0.33F, 0.34F},
                                                {0.55F, 0.22F, 0.17F}, 7),
                                    0.07F),
               1.4F};
    p.wood = {builder.add_textured(paint_planks(256, {0.42F, 0.27F, 0.16F}, 6, 8), 0.02F), 1.4F};
    p.roof = {builder.add_textured(paint_roof_tiles(256, {0.78F, 0.42F, 0.28F}, 9)), 1.4F};
    p.terracotta = {builder.add_textured(paint_stone(128, {0.70F, 0.40F, 0.28F}, 10)), 1.0F};
    Material iron;
    iron.diffuse = vec3{0.03F};
    iron.specular = vec3{0.08F};
    iron.shininess = 24.0F;
    p.iron = {builder.add_material(iron), 1.0F};
    const vec3 gold{0.80F, 0.64F, 0.30F};
    p.red_cloth = builder.add_textured(paint_damask(512, {0.55F, 0.08F, 0.08F}, gold, 11), 0.015F);
    p.green_cloth =
        builder.add_textured(paint_damask(512, {0.12F, 0.33F, 0.17F}, gold, 12), 0.015F);
    p.blue_cloth = builder.add_textured(paint_damask(512, {0.12F, 0.18F, 0.45F}, gold, 13), 0.015F);
    p.lace = builder.add_cut_out(paint_lace(512, {0.92F, 0.89F, 0.80F}, {0.60F, 0.14F, 0.12F}));
    p.pennant = builder.add_cut_out(paint_lace(256, {0.62F, 0.12F, 0.14F}, gold));
    p.leaf = builder.add_cut_out(paint_leaf(128, {0.26F, 0.50F, 0.18F}, 14));
    p.foliage = builder.add_cut_out(paint_foliage(256, {0.30F, 0.50F, 0.16F}, 60, 15));
    p.glow = builder.add_glowing({2.6F, 1.9F, 1.0F});
    Material water;
    water.diffuse = {0.06F, 0.16F, 0.18F};
    water.specular = vec3{0.25F};
    water.shininess = 80.0F;
    water.reflectance = 0.3F;
    p.water = builder.add_material(water);
    return p;
}

}  // namespace foverig::builtin::atrium
