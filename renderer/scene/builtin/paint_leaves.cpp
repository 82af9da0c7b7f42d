#include <vector>

#include "renderer/scene/builtin/hash.h"
#include "renderer/scene/builtin/noise.h"
#include "renderer/scene/builtin/painters.h"

namespace foverig::builtin {
namespace {

/// Where p lies in a leaf that starts at `root` and points along `turns`: x along it (0..1), y
/// across as a share of its half width (|y| < 1 inside).
class Leaf {
  public:
    Leaf(vec2 root, float turns, float length, float width)
        : root_(root), along_(vec2{cosine(turns), sine(turns)} / length), width_(width) {}

    vec2 at(vec2 p) const {
        const vec2 d = p - root_;
        const float along = d.x * along_.x + d.y * along_.y;
        if (along <= 0.0F || along >= 1.0F) return {along, 9.0F};
        const float across = d.y * along_.x - d.x * along_.y;
        // Widest a third of the way up, pointed at the tip.
        const float half = width_ * std::sqrt(along) * (1.0F - along) * 2.6F;
        return {along, across / half};
    }

  private:
    vec2 root_;
    vec2 along_;  ///< its direction over its length
    float width_;
};

vec3 leaf_colour(const vec3& colour, vec2 at, float tone) {
    const float rib = 1.0F - smoothstep(0.03F, 0.12F, std::fabs(at.y));
    const float veins = smoothstep(0.6F, 1.0F, sine(at.x * 7.0F + std::fabs(at.y) * 0.8F));
    return colour * (0.72F + tone + 0.28F * at.x) * (1.0F + 0.25F * rib + 0.1F * veins);
}

}  // namespace

Canvas paint_leaf(std::uint32_t size_px, const vec3& colour, std::uint32_t seed) {
    const Leaf leaf{{0.5F, 1.0F}, -0.25F, 1.0F, 0.42F};
    return paint_canvas(size_px, size_px, [&](vec2 uv) {
        const vec2 at = leaf.at(uv);
        const float speckle = 0.1F * fractal_noise(uv, 8, 3, seed);
        const float wavy = 1.0F + 0.08F * sine(at.x * 9.0F);
        return vec4{leaf_colour(colour, at, speckle), std::fabs(at.y) < wavy ? 1.0F : 0.0F};
    });
}

Canvas paint_foliage(std::uint32_t size_px, const vec3& colour, int count, std::uint32_t seed) {
    const float size = 1.15F / std::sqrt(static_cast<float>(count));
    std::vector<Leaf> leaves;
    Dice dice(seed);
    for (int i = 0; i < count; ++i) {
        const float turns = dice.unit();
        const float reach = (0.47F - 0.9F * size) * std::sqrt(dice.unit());
        const vec2 root{0.5F + reach * cosine(turns), 0.5F + reach * sine(turns)};
        const float bent = dice.between(-0.12F, 0.12F);
        leaves.emplace_back(root, turns + bent, size * dice.between(0.8F, 1.2F), 0.36F);
    }
    return paint_canvas(size_px, size_px, [&](vec2 uv) {
        for (std::size_t i = 0; i < leaves.size(); ++i) {
            const vec2 at = leaves[i].at(uv);
            if (std::fabs(at.y) >= 1.0F) continue;
            const float tone = 0.35F * (unit_of(hash(seed, static_cast<std::uint32_t>(i))) - 0.5F);
            return vec4{leaf_colour(colour, at, tone), 1.0F};
        }
        return vec4{colour * 0.7F, 0.0F};
    });
}

}  // namespace foverig::builtin
