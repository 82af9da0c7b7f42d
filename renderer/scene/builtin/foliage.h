#pragma once
#include "renderer/scene/builtin/mesh.h"

namespace foverig::builtin {

/// A tree's crown of leaf cards, facing roughly outwards, about the origin. `material` has alpha.
Mesh make_crown(std::uint16_t material, float radius_m, int cards, std::uint32_t seed);

}  // namespace foverig::builtin
