#include "renderer/scene/builtin/voxel_houses.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "renderer/scene/builtin/hash.h"

namespace foverig::builtin::voxel {
namespace {

struct Style {
    Block wall, ground_wall, post, roof;
};
constexpr std::array<Style, 8> kStyles{
    Style{Block::plaster, Block::cobble, Block::log, Block::tiles},
    Style{Block::ochre, Block::cobble, Block::log, Block::tiles},
    Style{Block::rose, Block::ashlar, Block::log, Block::slate},
    Style{Block::brick, Block::brick, Block::ashlar, Block::slate},
    Style{Block::planks, Block::cobble, Block::log, Block::slate},
    Style{Block::plaster, Block::plaster, Block::log, Block::slate},
    Style{Block::ashlar, Block::ashlar, Block::stone, Block::tiles},
    Style{Block::brick, Block::ashlar, Block::brick, Block::tiles}};

constexpr int kStorey = 4;

/// Wall block of a storey at position i of n along the wall, dy above the storey's floor.
Block wall_block(const Style& style, bool ground_floor, int i, int n, int dy) {
    if (i == 0 || i == n - 1) return style.post;
    if (dy == kStorey - 1) return style.post;
    const bool window = std::abs(i - n / 2) % 3 == 0 && i > 1 && i < n - 2;
    if (window && (dy == 1 || dy == 2)) return Block::glass;
    return ground_floor ? style.ground_wall : style.wall;
}

void build_walls(Grid& grid, const Plot& plot, const Style& style, int base, bool ground_floor) {
    for (int dy = 0; dy < kStorey; ++dy) {
        for (int x = plot.x0; x <= plot.x1; ++x) {
            const Block b = wall_block(style, ground_floor, x - plot.x0, plot.width(), dy);
            grid.set(x, base + dy, plot.z0, b);
            grid.set(x, base + dy, plot.z1, b);
        }
        for (int z = plot.z0; z <= plot.z1; ++z) {
            const Block b = wall_block(style, ground_floor, z - plot.z0, plot.depth(), dy);
            grid.set(plot.x0, base + dy, z, b);
            grid.set(plot.x1, base + dy, z, b);
        }
    }
    grid.fill(plot.x0 + 1, base + kStorey - 1, plot.z0 + 1, plot.x1 - 1, base + kStorey - 1,
              plot.z1 - 1, Block::planks);
}

/// Gable along the longer side, one block of overhang; the gables are closed with the wall's block.
void build_gable(Grid& grid, const Plot& plot, const Style& style, int base) {
    const bool along_x = plot.width() >= plot.depth();
    const int across0 = along_x ? plot.z0 : plot.x0;
    const int across1 = along_x ? plot.z1 : plot.x1;
    const int along0 = along_x ? plot.x0 : plot.z0;
    const int along1 = along_x ? plot.x1 : plot.z1;
    const auto put = [&](int along, int y, int across, Block b) {
        along_x ? grid.set(along, y, across, b) : grid.set(across, y, along, b);
    };
    for (int step = 0; across0 - 1 + step <= across1 + 1 - step; ++step) {
        const int y = base - 1 + step;
        for (int along = along0 - 1; along <= along1 + 1; ++along) {
            put(along, y, across0 - 1 + step, style.roof);
            put(along, y, across1 + 1 - step, style.roof);
        }
        for (int across = across0 + step; across <= across1 - step; ++across) {
            const bool light = across == (across0 + across1) / 2 && step == 2;
            put(along0, y, across, light ? Block::glass : style.wall);
            put(along1, y, across, light ? Block::glass : style.wall);
        }
    }
}

void lay_foundation(Grid& grid, const Plot& plot) {
    grid.fill(plot.x0, plot.ground - 4, plot.z0, plot.x1, plot.ground, plot.z1, Block::cobble);
    grid.fill(plot.x0, plot.ground + 1, plot.z0, plot.x1, plot.ground + 12, plot.z1, Block::air);
}

}  // namespace

void build_house(Grid& grid, const Plot& plot, std::uint32_t seed) {
    const Style& style = kStyles[hash(seed, 1U) % kStyles.size()];
    const int storeys =
        1 + static_cast<int>(hash(seed, 2U) % 3U) + (hash(seed, 3U) % 5U == 0U ? 1 : 0);
    lay_foundation(grid, plot);
    int base = plot.ground + 1;
    for (int storey = 0; storey < storeys; ++storey, base += kStorey)
        build_walls(grid, plot, style, base, storey == 0);
    build_gable(grid, plot, style, base);
    const int door = (plot.x0 + plot.x1) / 2;
    grid.fill(door, plot.ground + 1, plot.z1, door, plot.ground + 2, plot.z1, Block::air);
    grid.set(door, plot.ground + 1, plot.z1 + 1, Block::cobble);
    grid.set(door + 1, plot.ground + 3, plot.z1 + 1, Block::lamp);
    const int chimney_x = plot.x0 + 2 + static_cast<int>(hash(seed, 4U) % 3U);
    const int top = base + std::min(plot.width(), plot.depth()) / 2 + 2;
    grid.fill(chimney_x, plot.ground + 1, plot.z0 + 2, chimney_x, top, plot.z0 + 2, Block::brick);
}

void build_tower(Grid& grid, const Plot& plot, int height, bool spire) {
    lay_foundation(grid, plot);
    const int base = plot.ground + 1;
    const Style style{Block::ashlar, Block::ashlar, Block::stone, Block::slate};
    for (int y = base; y + kStorey <= base + height; y += kStorey)
        build_walls(grid, plot, style, y, false);
    const int top = base + height / kStorey * kStorey;
    if (!spire) {
        grid.fill(plot.x0 - 1, top, plot.z0 - 1, plot.x1 + 1, top, plot.z1 + 1, Block::stone);
        for (int x = plot.x0 - 1; x <= plot.x1 + 1; ++x) {
            for (int z = plot.z0 - 1; z <= plot.z1 + 1; ++z) {
                const bool rim = x < plot.x0 || x > plot.x1 || z < plot.z0 || z > plot.z1;
                if (rim)
                    grid.fill(x, top + 1, z, x, top + ((x + z) % 2 == 0 ? 2 : 1), z, Block::ashlar);
            }
        }
        return;
    }
    for (int y = top, inset = -1; plot.x0 + inset <= plot.x1 - inset; ++y) {
        grid.fill(plot.x0 + inset, y, plot.z0 + inset, plot.x1 - inset, y, plot.z1 - inset,
                  Block::slate);
        if ((y - top) % 2 == 1) ++inset;
    }
}

void build_church(Grid& grid, const Plot& plot) {
    const Style style{Block::ashlar, Block::ashlar, Block::stone, Block::slate};
    lay_foundation(grid, plot);
    const Plot nave{plot.x0, plot.z0, plot.x1, plot.z1 - 6, plot.ground};
    int base = plot.ground + 1;
    for (int storey = 0; storey < 3; ++storey, base += kStorey) {
        build_walls(grid, nave, style, base, false);
        if (storey < 2)
            grid.fill(nave.x0 + 1, base + kStorey - 1, nave.z0 + 1, nave.x1 - 1, base + kStorey - 1,
                      nave.z1 - 1, Block::air);
    }
    build_gable(grid, nave, style, base);
    for (int z = nave.z0 + 1; z < nave.z1; z += 5) {
        for (const int x : {nave.x0 - 1, nave.x1 + 1}) {
            grid.fill(x, plot.ground + 1, z, x, plot.ground + 8, z, Block::stone);
        }
    }
    const int middle = (plot.x0 + plot.x1) / 2;
    build_tower(grid, {middle - 3, plot.z1 - 6, middle + 3, plot.z1, plot.ground}, 28, true);
    grid.fill(middle - 1, plot.ground + 1, plot.z1, middle + 1, plot.ground + 3, plot.z1,
              Block::air);
}

void build_market(Grid& grid, const Plot& plot, std::uint32_t seed) {
    grid.fill(plot.x0, plot.ground, plot.z0, plot.x1, plot.ground, plot.z1, Block::gravel);
    const int cx = (plot.x0 + plot.x1) / 2;
    const int cz = (plot.z0 + plot.z1) / 2;
    for (int i = 0; i < 4; ++i) {
        const int x = i % 2 == 0 ? plot.x0 + 1 : plot.x1 - 4;
        const int z = i < 2 ? plot.z0 + 1 : plot.z1 - 4;
        for (const int dx : {0, 3})
            for (const int dz : {0, 3})
                grid.fill(x + dx, plot.ground + 1, z + dz, x + dx, plot.ground + 3, z + dz,
                          Block::log);
        for (int dx = 0; dx < 4; ++dx) {
            const Block wool = dx % 2 == 0 ? Block::red_wool : Block::white_wool;
            grid.fill(x + dx, plot.ground + 4, z, x + dx, plot.ground + 4, z + 3, wool);
        }
        grid.fill(
            x + 1, plot.ground + 1, z, x + 2, plot.ground + 1, z,
            hash(seed, static_cast<std::uint32_t>(i)) % 2U == 0U ? Block::hay : Block::planks);
    }
    grid.fill(cx - 1, plot.ground + 1, cz - 1, cx + 1, plot.ground + 1, cz + 1, Block::cobble);
    grid.set(cx, plot.ground + 1, cz, Block::water);
}

}  // namespace foverig::builtin::voxel
