#pragma once
// Blocks of one metre. Columns are addressed by whole metres from the town's middle, so that a
// larger world has the same town at its heart.
#include <cstdint>
#include <vector>

namespace foverig::builtin::voxel {

enum class Block : std::uint8_t {
    air,
    grass,
    dirt,
    stone,
    sand,
    gravel,
    water,
    log,
    planks,
    cobble,
    brick,
    plaster,
    ochre,
    rose,
    tiles,
    slate,
    ashlar,
    hay,
    red_wool,
    white_wool,
    lamp,
    leaves,
    blossom,
    glass,  // cut-outs, in the part with alpha
    count,
};

inline bool is_cut_out(Block b) {
    return b >= Block::leaves;
}
/// Hides the faces behind it.
inline bool is_solid(Block b) {
    return b != Block::air && !is_cut_out(b);
}

class Grid {
  public:
    Grid(int side, int height)
        : side_(side), height_(height), blocks_(static_cast<std::size_t>(side) * side * height) {}

    int side() const { return side_; }
    int height() const { return height_; }
    int half() const { return side_ / 2; }

    bool inside(int x, int y, int z) const {
        return x >= -half() && x < side_ - half() && z >= -half() && z < side_ - half() && y >= 0 &&
               y < height_;
    }
    Block at(int x, int y, int z) const {
        return inside(x, y, z) ? blocks_[index(x, y, z)] : Block::air;
    }
    /// What falls outside the world is dropped.
    void set(int x, int y, int z, Block block) {
        if (inside(x, y, z)) blocks_[index(x, y, z)] = block;
    }
    /// Both corners belong to the box.
    void fill(int x0, int y0, int z0, int x1, int y1, int z1, Block block) {
        for (int y = y0; y <= y1; ++y)
            for (int z = z0; z <= z1; ++z)
                for (int x = x0; x <= x1; ++x) set(x, y, z, block);
    }
    /// One layer's rows, from the lowest z; each runs from the lowest x.
    const Block* layer(int y) const {
        return blocks_.data() + static_cast<std::size_t>(y) * side_ * side_;
    }

  private:
    std::size_t index(int x, int y, int z) const {
        return (static_cast<std::size_t>(y) * side_ + static_cast<std::size_t>(z + half())) *
                   side_ +
               static_cast<std::size_t>(x + half());
    }

    int side_;
    int height_;
    std::vector<Block> blocks_;
};

}  // namespace foverig::builtin::voxel
