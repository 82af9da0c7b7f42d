#pragma once
#include "renderer/scene/builtin/scene_builder.h"
#include "renderer/scene/builtin/voxel_mesher.h"

namespace foverig::builtin::voxel {

/// Paints every block's 16 x 16 pixels and adds its materials.
Skins add_skins(SceneBuilder& builder);

/// Two crossed cards of grass or flowers: materials with alpha.
struct Tufts {
    std::uint16_t grass;
    std::uint16_t red;
    std::uint16_t yellow;
};
Tufts add_tufts(SceneBuilder& builder);

}  // namespace foverig::builtin::voxel
