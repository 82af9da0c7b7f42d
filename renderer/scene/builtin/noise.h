#pragma once
// Gradient noise, about -1..1, mean 0, smooth to the second derivative.
#include <cstdint>

#include "renderer/vec.h"

namespace foverig::builtin {

/// Repeats every `period` lattice cells in x and y; period >= 1.
float noise(vec2 p, int period, std::uint32_t seed);
float noise(const vec3& p, std::uint32_t seed);

/// Sum of `octaves`, each twice as fine and half as strong. The 2D one takes p in [0, 1) and tiles.
float fractal_noise(vec2 uv, int cells, int octaves, std::uint32_t seed);
float fractal_noise(const vec3& p, int octaves, std::uint32_t seed);

/// Distances to the nearest and second nearest of one random point a cell, in cells; uv tiles.
struct Cells {
    float nearest;
    float second;
    std::uint32_t id;  ///< of the nearest point's cell
};
Cells cell_noise(vec2 uv, int cells, std::uint32_t seed);

}  // namespace foverig::builtin
