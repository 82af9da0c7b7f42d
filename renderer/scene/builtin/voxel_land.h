#pragma once
// Ground, river and streets of the voxel town, as functions of the column.
#include "renderer/scene/builtin/voxel_grid.h"

namespace foverig::builtin::voxel {

inline constexpr int kWorldHeight = 80;
inline constexpr int kWaterLevel = 14;
inline constexpr int kBlockPitch = 40;  ///< from street to street
inline constexpr int kStreetHalf = 3;   ///< streets cover -3 .. 2 about each multiple

struct Land {
    int town_radius;

    /// Height of the highest block before building; streets and lots follow it.
    int ground(int x, int z) const;
    bool in_town(int x, int z) const;
    bool in_river(int x, int z) const;
    bool in_street(int x, int z) const;
};

/// Ground blocks, water, streets with bridges.
void lay_land(Grid& grid, const Land& land);
/// Forest and single trees outside of the town.
void grow_forest(Grid& grid, const Land& land);
/// A tree rooted on the block at y.
void plant_tree(Grid& grid, int x, int y, int z, std::uint32_t seed);

/// i modulo n, 0 .. n - 1 for negative i too.
inline int wrapped(int i, int n) {
    return (i % n + n) % n;
}

}  // namespace foverig::builtin::voxel
