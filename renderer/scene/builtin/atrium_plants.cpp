#include "renderer/scene/builtin/atrium_plan.h"
#include "renderer/scene/builtin/grid.h"
#include "renderer/scene/builtin/hash.h"
#include "renderer/scene/builtin/shapes.h"

namespace foverig::builtin::atrium {

Mesh make_fern(const Paints& paints, std::uint32_t seed) {
    Mesh mesh;
    Dice dice(seed);
    constexpr int kLeaves = 22;
    for (int i = 0; i < kLeaves; ++i) {
        const float rise = dice.between(0.5F, 1.05F);
        const float reach = dice.between(0.25F, 0.7F);
        const float droop = dice.between(0.1F, 0.5F);
        const float half = dice.between(0.07F, 0.1F);
        const auto point = [&](float u, float v) {
            const float fold = 0.03F * std::fabs(2.0F * u - 1.0F) * sine(0.5F * v);
            return vec3{(u - 0.5F) * 2.0F * half, rise * v - droop * v * v * v + fold,
                        0.05F + reach * v * v};
        };
        Mesh leaf;
        add_grid(leaf, paints.leaf, 2, 6, false, point, [](float u, float v) {
            return vec2{u, 1.0F - v};
        });
        const float turns = (static_cast<float>(i) + dice.between(-0.3F, 0.3F)) * 0.618F;
        mesh.append(leaf, {{0.0F, 0.45F, 0.0F}, turns});
    }
    return mesh;
}

Mesh make_ivy(const Paints& paints, std::uint32_t seed) {
    // Hangs over the rail: rooted on it, z > 0 is over the court.
    Mesh mesh;
    Dice dice(seed);
    constexpr int kCards = 36;
    for (int i = 0; i < kCards; ++i) {
        const float along = dice.between(-1.0F, 1.0F);
        const float reach = (1.0F - 0.6F * along * along) * dice.between(0.2F, 1.0F);
        const float fall = reach * reach * dice.between(0.6F, 2.2F);
        const float size = dice.between(0.34F, 0.52F);
        const vec3 across = rotate_y({size, 0.0F, 0.0F}, dice.between(-0.12F, 0.12F));
        const vec3 up = vec3{0.0F, size, -size * dice.between(-0.1F, 0.5F)};
        const vec3 centre{0.9F * along, 0.12F - fall, 0.2F + 0.28F * reach};
        add_card(mesh, paints.foliage, centre - 0.5F * (across + up), across, up);
    }
    return mesh;
}

}  // namespace foverig::builtin::atrium
