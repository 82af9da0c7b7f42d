#include "renderer/scene/builtin/voxel_land.h"

#include <algorithm>

#include "renderer/scene/builtin/exact.h"
#include "renderer/scene/builtin/hash.h"
#include "renderer/scene/builtin/noise.h"

namespace foverig::builtin::voxel {
namespace {

vec3 at_scale(int x, int z, float scale_m) {
    return {static_cast<float>(x) / scale_m, 0.5F, static_cast<float>(z) / scale_m};
}

float distance_m(int x, int z) {
    return length(vec2{static_cast<float>(x), static_cast<float>(z)});
}

/// Distance to the river's middle line, along z.
float from_river_m(int x, int z) {
    const float middle = 62.0F + 13.0F * sine(static_cast<float>(x) / 170.0F) +
                         0.0006F * static_cast<float>(x) * static_cast<float>(x) /
                             (1.0F + 0.002F * std::fabs(static_cast<float>(x)));
    return std::fabs(static_cast<float>(z) - middle);
}

}  // namespace

int Land::ground(int x, int z) const {
    const float rolling = 3.5F * noise(at_scale(x, z, 95.0F), 41);
    const float outside =
        smoothstep(0.0F, 70.0F, distance_m(x, z) - static_cast<float>(town_radius));
    const float hill = 15.0F + 26.0F * fractal_noise(at_scale(x, z, 110.0F), 4, 42);
    float height = 20.5F + rolling + outside * std::max(0.0F, hill);
    const float bank = smoothstep(5.0F, 20.0F, from_river_m(x, z));
    height = mix(std::min(height, static_cast<float>(kWaterLevel) - 4.0F), height, bank);
    return static_cast<int>(clamp(height, 4.0F, 56.0F));
}

bool Land::in_town(int x, int z) const {
    return distance_m(x, z) < static_cast<float>(town_radius);
}

bool Land::in_river(int x, int z) const {
    return ground(x, z) < kWaterLevel;
}

bool Land::in_street(int x, int z) const {
    return in_town(x, z) && (wrapped(x + kStreetHalf, kBlockPitch) < 2 * kStreetHalf ||
                             wrapped(z + kStreetHalf, kBlockPitch) < 2 * kStreetHalf);
}

void lay_land(Grid& grid, const Land& land) {
    const int half = grid.half();
    for (int z = -half; z < grid.side() - half; ++z) {
        for (int x = -half; x < grid.side() - half; ++x) {
            const int top = land.ground(x, z);
            const bool street = land.in_street(x, z);
            for (int y = 0; y < top - 2; ++y) grid.set(x, y, z, Block::stone);
            const bool shore = top <= kWaterLevel + 1;
            const bool rocky = top > 44;
            const Block crust = shore ? Block::sand : rocky ? Block::stone : Block::dirt;
            for (int y = std::max(0, top - 2); y < top; ++y) grid.set(x, y, z, crust);
            const bool kerb = wrapped(x + kStreetHalf, kBlockPitch) % 5 == 0 ||
                              wrapped(z + kStreetHalf, kBlockPitch) % 5 == 0;
            const Block paving = kerb ? Block::cobble : Block::gravel;
            grid.set(x, top, z,
                     street && !shore ? paving
                     : shore          ? Block::sand
                     : rocky          ? Block::stone
                                      : Block::grass);
            for (int y = top + 1; y <= kWaterLevel; ++y) grid.set(x, y, z, Block::water);
            if (street && top <= kWaterLevel + 1) {
                grid.set(x, kWaterLevel + 2, z, kerb ? Block::log : Block::planks);
                if (wrapped(x + z, 8) == 0 && kerb)
                    grid.fill(x, top, z, x, kWaterLevel + 1, z, Block::log);
            }
        }
    }
}

void plant_tree(Grid& grid, int x, int y, int z, std::uint32_t seed) {
    const int trunk = 4 + static_cast<int>(hash(seed) % 3U);
    const Block crown = hash(seed, 5U) % 7U == 0U ? Block::blossom : Block::leaves;
    const float radius = 2.2F + 0.9F * unit_of(hash(seed, 6U));
    for (int dy = -2; dy <= 3; ++dy) {
        for (int dz = -3; dz <= 3; ++dz) {
            for (int dx = -3; dx <= 3; ++dx) {
                const vec3 d{static_cast<float>(dx), 1.25F * static_cast<float>(dy),
                             static_cast<float>(dz)};
                const float ragged = unit_of(hash(seed, static_cast<std::uint32_t>(dx + 9),
                                                  static_cast<std::uint32_t>(dy + 9),
                                                  static_cast<std::uint32_t>(dz + 9)));
                if (length(d) > radius + 0.5F * ragged - 0.25F) continue;
                if (grid.at(x + dx, y + trunk + dy, z + dz) == Block::air)
                    grid.set(x + dx, y + trunk + dy, z + dz, crown);
            }
        }
    }
    grid.fill(x, y + 1, z, x, y + trunk, z, Block::log);
}

void grow_forest(Grid& grid, const Land& land) {
    const int half = grid.half();
    constexpr int kSpacing = 6;
    for (int cz = -half / kSpacing; cz < half / kSpacing; ++cz) {
        for (int cx = -half / kSpacing; cx < half / kSpacing; ++cx) {
            const std::uint32_t seed =
                hash(static_cast<std::uint32_t>(cx), static_cast<std::uint32_t>(cz), 43U);
            const int x = cx * kSpacing + static_cast<int>(seed % kSpacing);
            const int z = cz * kSpacing + static_cast<int>((seed >> 8U) % kSpacing);
            if (land.in_town(x, z)) continue;
            const int top = land.ground(x, z);
            const float density = 0.25F + 0.9F * fractal_noise(at_scale(x, z, 60.0F), 3, 44);
            if (grid.at(x, top, z) != Block::grass || unit_of(hash(seed)) > density) continue;
            plant_tree(grid, x, top, z, seed);
        }
    }
}

}  // namespace foverig::builtin::voxel
