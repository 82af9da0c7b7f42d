#include "renderer/scene/builtin/voxel_mesher.h"

#include <algorithm>

namespace foverig::builtin::voxel {
namespace {

constexpr std::uint32_t kNoVertex = 0xffff'ffffU;

enum Direction { kUp, kDown, kEast, kWest, kSouth, kNorth, kDirections };  // +y -y +x -x +z -z

constexpr std::array<vec3, kDirections> kNormals{vec3{0, 1, 0},  vec3{0, -1, 0}, vec3{1, 0, 0},
                                                 vec3{-1, 0, 0}, vec3{0, 0, 1},  vec3{0, 0, -1}};

// Corners of a face as offsets (x, y, z) from its block, counter-clockwise from outside.
constexpr std::uint8_t kCorners[kDirections][4][3] = {
    {{0, 1, 1}, {1, 1, 1}, {1, 1, 0}, {0, 1, 0}}, {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}},
    {{1, 0, 1}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}}, {{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}},
    {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, {{1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {1, 1, 0}}};

class Mesher {
  public:
    Mesher(const Grid& grid, const Skins& skins, bool cut_outs)
        : grid_(grid),
          skins_(skins),
          cut_outs_(cut_outs),
          row_(static_cast<std::size_t>(grid.side()) + 1) {
        for (auto& direction : corners_)
            for (auto& plane : direction) plane.assign(row_ * row_, kNoVertex);
    }

    Mesh run() {
        std::size_t faces = 0;
        visit([&](int, int, int, Direction, Block) { ++faces; });
        // About 1.4 corners a face are left after sharing; what is reserved in vain is never
        // touched.
        mesh_.reserve(faces * 3 / 2, faces * 2);
        visit([&](int x, int y, int z, Direction d, Block b) { add_face(x, y, z, d, b); });
        return std::move(mesh_);
    }

  private:
    bool ours(Block b) const { return b != Block::air && is_cut_out(b) == cut_outs_; }
    /// Glass shows glass's frame through; leaves hide leaves; anything solid hides all.
    bool hidden(Block b, Block neighbour) const { return is_solid(neighbour) || neighbour == b; }

    template <class Visit>
    void visit(Visit&& face) {
        const int side = grid_.side();
        const auto n = static_cast<std::size_t>(side);
        for (int y = 0; y < grid_.height(); ++y) {
            begin_layer(y);
            const Block* layer = grid_.layer(y);
            const Block* above = y + 1 < grid_.height() ? grid_.layer(y + 1) : nullptr;
            const Block* below = y > 0 ? grid_.layer(y - 1) : nullptr;
            for (int z = 0; z < side; ++z) {
                for (int x = 0; x < side; ++x) {
                    const std::size_t i =
                        static_cast<std::size_t>(z) * n + static_cast<std::size_t>(x);
                    const Block b = layer[i];
                    if (!ours(b)) continue;
                    if (above == nullptr || !hidden(b, above[i])) face(x, y, z, kUp, b);
                    if (below != nullptr && !hidden(b, below[i])) face(x, y, z, kDown, b);
                    if (x + 1 < side && !hidden(b, layer[i + 1])) face(x, y, z, kEast, b);
                    if (x > 0 && !hidden(b, layer[i - 1])) face(x, y, z, kWest, b);
                    if (z + 1 < side && !hidden(b, layer[i + n])) face(x, y, z, kSouth, b);
                    if (z > 0 && !hidden(b, layer[i - n])) face(x, y, z, kNorth, b);
                }
            }
        }
    }

    void begin_layer(int y) {
        if (y == 0) first_of_previous_ = first_of_layer_ = 0;
        first_of_previous_ = first_of_layer_;
        first_of_layer_ = static_cast<std::uint32_t>(mesh_.positions_m.size());
        layer_is_odd_ = y % 2 == 1;
    }

    /// Vertices only ever get higher numbers, so a number tells in which layer it was made, and
    /// tables of corners need no clearing: corners at height y are kept in plane y % 2.
    std::uint32_t corner(int x, int y, int z, Direction d, const std::uint8_t* offset) {
        const bool upper = offset[1] == 1;
        const bool flat = d == kUp || d == kDown;
        const std::size_t plane = flat ? 0U : static_cast<std::size_t>(layer_is_odd_ != upper);
        const std::size_t cx = static_cast<std::size_t>(x + offset[0]);
        const std::size_t cz = static_cast<std::size_t>(z + offset[2]);
        std::uint32_t& vertex = corners_[d][plane][cz * row_ + cx];
        const std::uint32_t oldest = flat || upper ? first_of_layer_ : first_of_previous_;
        if (vertex != kNoVertex && vertex >= oldest) return vertex;
        const auto half = static_cast<float>(grid_.half());
        const vec3 p{static_cast<float>(cx) - half, static_cast<float>(y + offset[1]),
                     static_cast<float>(cz) - half};
        const vec2 texcoord =
            flat ? vec2{p.x, p.z} : vec2{d == kEast || d == kWest ? p.z : p.x, -p.y};
        vertex = mesh_.add_vertex(p, kNormals[d], texcoord);
        return vertex;
    }

    void add_face(int x, int y, int z, Direction d, Block b) {
        std::uint32_t v[4];
        for (int i = 0; i < 4; ++i) v[i] = corner(x, y, z, d, kCorners[d][i]);
        const Skin& skin = skins_[static_cast<std::size_t>(b)];
        const std::uint16_t material = d == kUp ? skin.top : d == kDown ? skin.bottom : skin.side;
        mesh_.triangles.emplace_back(v[0], v[1], v[2]);
        mesh_.triangles.emplace_back(v[0], v[2], v[3]);
        mesh_.materials.push_back(material);
        mesh_.materials.push_back(material);
    }

    const Grid& grid_;
    const Skins& skins_;
    bool cut_outs_;
    std::size_t row_;
    std::array<std::array<std::vector<std::uint32_t>, 2>, kDirections> corners_;
    std::uint32_t first_of_layer_ = 0;
    std::uint32_t first_of_previous_ = 0;
    bool layer_is_odd_ = false;
    Mesh mesh_;
};

}  // namespace

Mesh mesh_blocks(const Grid& grid, const Skins& skins, bool cut_outs) {
    return Mesher(grid, skins, cut_outs).run();
}

}  // namespace foverig::builtin::voxel
