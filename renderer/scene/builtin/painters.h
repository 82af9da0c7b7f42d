#pragma once
// Procedural textures; each tiles unless it says otherwise. Colours are sRGB, 0..1.
#include "renderer/scene/builtin/canvas.h"

namespace foverig::builtin {

// paint_stone.cpp
Canvas paint_stone(std::uint32_t size_px, const vec3& colour, std::uint32_t seed);
Canvas paint_plaster(std::uint32_t size_px, const vec3& colour, std::uint32_t seed);
Canvas paint_marble(std::uint32_t size_px, const vec3& colour, const vec3& vein,
                    std::uint32_t seed);

// paint_masonry.cpp: `across` x `rows` stones in one repeat, each row shifted by half a stone.
struct Masonry {
    int across = 4;
    int rows = 8;
    float joint = 0.06F;    ///< width of the mortar, as a share of a stone's height
    float variety = 0.12F;  ///< difference of brightness between stones
    vec3 stone{0.6F};
    vec3 mortar{0.7F};
    bool shifted = true;
};
Canvas paint_masonry(std::uint32_t size_px, const Masonry& masonry, std::uint32_t seed);
Canvas paint_roof_tiles(std::uint32_t size_px, const vec3& colour, std::uint32_t seed);
/// A square floor slab inlaid with a lozenge and a border.
Canvas paint_inlay(std::uint32_t size_px, const vec3& light, const vec3& dark, const vec3& accent,
                   std::uint32_t seed);

// paint_wood.cpp
Canvas paint_planks(std::uint32_t size_px, const vec3& colour, int planks, std::uint32_t seed);
Canvas paint_bark(std::uint32_t size_px, const vec3& colour, std::uint32_t seed);

// paint_cloth.cpp
Canvas paint_damask(std::uint32_t size_px, const vec3& ground, const vec3& motif,
                    std::uint32_t seed);
/// Does not tile in v: a border and fringe at the bottom; the field is an open lattice (alpha).
Canvas paint_lace(std::uint32_t size_px, const vec3& thread, const vec3& border);

// paint_leaves.cpp, with alpha, not tiling
Canvas paint_leaf(std::uint32_t size_px, const vec3& colour, std::uint32_t seed);
/// That many leaves, overlapping towards the middle.
Canvas paint_foliage(std::uint32_t size_px, const vec3& colour, int count, std::uint32_t seed);

// paint_pattern.cpp
Canvas paint_checker(std::uint32_t size_px, int squares, const vec3& light, const vec3& dark);
Canvas paint_noise(std::uint32_t size_px, int cells, float contrast, std::uint32_t seed);

}  // namespace foverig::builtin
