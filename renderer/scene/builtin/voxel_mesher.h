#pragma once
#include <array>

#include "renderer/scene/builtin/mesh.h"
#include "renderer/scene/builtin/voxel_grid.h"

namespace foverig::builtin::voxel {

/// Materials of a block's faces.
struct Skin {
    std::uint16_t top = 0;
    std::uint16_t side = 0;
    std::uint16_t bottom = 0;
};
using Skins = std::array<Skin, static_cast<std::size_t>(Block::count)>;

/// The faces that can be seen, of the solid blocks or of the cut-outs. Faces at the world's rim and
/// below it are left out. Neighbouring faces of one plane share their corners: texcoords are world
/// positions, one repeat a block, whatever the material.
Mesh mesh_blocks(const Grid& grid, const Skins& skins, bool cut_outs);

}  // namespace foverig::builtin::voxel
