#include "renderer/scene/builtin/foliage.h"

#include "renderer/scene/builtin/hash.h"
#include "renderer/scene/builtin/shapes.h"

namespace foverig::builtin {

Mesh make_crown(std::uint16_t material, float radius_m, int cards, std::uint32_t seed) {
    Mesh mesh;
    Dice dice(seed);
    for (int i = 0; i < cards; ++i) {
        const float height = dice.between(-1.0F, 1.0F);
        const float ring = std::sqrt(1.0F - height * height);
        const float around = dice.unit();
        const vec3 out{ring * cosine(around), height, ring * sine(around)};
        const float tilt_x = dice.between(-1.0F, 1.0F);
        const float tilt_y = dice.between(-0.4F, 0.4F);
        const float tilt_z = dice.between(-1.0F, 1.0F);
        const vec3 side = normalize({tilt_x, tilt_y, tilt_z});
        const vec3 up = normalize(cross(out, side));
        const vec3 across = cross(up, normalize(out + 0.6F * side));
        const float size = radius_m * dice.between(0.75F, 1.05F);
        const vec3 centre = out * radius_m * dice.between(0.45F, 0.8F);
        add_card(mesh, material, centre - 0.5F * size * (across + up), across * size, up * size);
    }
    return mesh;
}

}  // namespace foverig::builtin
