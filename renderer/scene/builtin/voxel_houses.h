#pragma once
#include "renderer/scene/builtin/voxel_grid.h"

namespace foverig::builtin::voxel {

/// Footprint of a building: corners belong to it; `ground` is the highest block of the lot.
struct Plot {
    int x0, z0, x1, z1;
    int ground;
    int width() const { return x1 - x0 + 1; }
    int depth() const { return z1 - z0 + 1; }
};

/// Hollow, with glazed windows, floors, a door on the side towards z1 and a pitched roof.
void build_house(Grid& grid, const Plot& plot, std::uint32_t seed);
/// Square tower with battlements or a spire.
void build_tower(Grid& grid, const Plot& plot, int height, bool spire);
void build_church(Grid& grid, const Plot& plot);
/// Stalls with striped roofs around a well.
void build_market(Grid& grid, const Plot& plot, std::uint32_t seed);

}  // namespace foverig::builtin::voxel
