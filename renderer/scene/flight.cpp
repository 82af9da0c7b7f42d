#include "renderer/scene/flight.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>

namespace foverig::scene_import {
namespace {

inline constexpr std::uint32_t kUnset = std::numeric_limits<std::uint32_t>::max();
inline constexpr float kEyeHeight_m = 1.65F;

struct Walk {
    std::vector<ivec3> cells;           ///< room cells at eye height
    std::vector<std::uint32_t> number;  ///< by grid index: into `cells`, or kUnset
    std::vector<int> clearance;
};

/// How far above the floor an eye goes: a person's height, or less in a scene that is smaller.
int eye_height_cells(const Occupancy& grid) {
    const float height_m =
        std::min(kEyeHeight_m, 0.4F * static_cast<float>(grid.size().y - 3) * grid.cell_m());
    return std::max(1, static_cast<int>(std::lround(height_m / grid.cell_m())));
}

Walk walkable(const Occupancy& grid, int least_clearance) {
    Walk walk;
    walk.number.assign(grid.cell_count(), kUnset);
    const int height = eye_height_cells(grid);
    for (int y = 1; y + 1 < grid.size().y; ++y)
        for (int z = 1; z + 1 < grid.size().z; ++z)
            for (int x = 1; x + 1 < grid.size().x; ++x) {
                const ivec3 cell(x, y, z);
                const int clear = std::min(grid.clearance(cell), 8);
                if (clear < least_clearance) continue;
                const Occupancy::Sight floor = grid.look(cell, ivec3(0, -1, 0));
                if (!floor.blocked || std::abs(floor.cells - height) > 1 || !grid.in_room(cell))
                    continue;
                walk.number[grid.index(cell)] = static_cast<std::uint32_t>(walk.cells.size());
                walk.cells.push_back(cell);
                walk.clearance.push_back(clear);
            }
    return walk;
}

/// Calls `visit(neighbour, step)` for the up to 26 walkable cells around one.
template <class Visit>
void for_neighbours(const Occupancy& grid, const Walk& walk, std::uint32_t at, const Visit& visit) {
    for (int i = 0; i < 27; ++i) {
        const ivec3 step(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        const ivec3 cell = walk.cells[at] + step;
        if (step == ivec3(0) || !grid.inside(cell)) continue;
        const std::uint32_t next = walk.number[grid.index(cell)];
        if (next != kUnset) visit(next, step);
    }
}

/// Shortest ways from one cell, a step near a wall counting more. `from[i]` is the cell before i.
struct Ways {
    std::vector<std::uint32_t> from;
    std::uint32_t furthest = 0;
};

Ways ways_from(const Occupancy& grid, const Walk& walk, std::uint32_t start) {
    Ways ways;
    ways.from.assign(walk.cells.size(), kUnset);
    ways.furthest = start;
    std::vector<float> length(walk.cells.size(), std::numeric_limits<float>::infinity());
    length[start] = 0.0F;
    using Entry = std::pair<float, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    open.emplace(0.0F, start);
    while (!open.empty()) {
        const auto [so_far, at] = open.top();
        open.pop();
        if (so_far > length[at]) continue;
        ways.furthest = at;
        for_neighbours(grid, walk, at,
                       [&, so_far = so_far, at = at](std::uint32_t next, const ivec3& step) {
                           const auto clear = static_cast<float>(walk.clearance[next]);
                           const float total =
                               so_far + glm::length(vec3(step)) * (1.0F + 4.0F / (clear * clear));
                           if (total >= length[next]) return;
                           length[next] = total;
                           ways.from[next] = at;
                           open.emplace(total, next);
                       });
    }
    return ways;
}

/// How much there is to see from a cell.
double interest(const Occupancy& grid, const ivec3& cell) {
    double sum = 0.0;
    for (int dy = -1; dy <= 1; ++dy)
        for (int dz = -1; dz <= 1; ++dz)
            for (int dx = -1; dx <= 1; ++dx)
                if (dx != 0 || dy != 0 || dz != 0)
                    sum += std::min(1000.0,
                                    static_cast<double>(grid.look(cell, ivec3(dx, dy, dz)).detail));
    return sum;
}

/// A cell of the connected space from which most is seen: the gap between a building's inner and
/// outer walls may be longer than its nave.
std::uint32_t best_space(const Occupancy& grid, const Walk& walk) {
    std::uint32_t start = 0;
    double best = -1.0;
    std::vector<bool> seen(walk.cells.size(), false);
    std::vector<std::uint32_t> open;
    for (std::uint32_t i = 0; i < walk.cells.size(); ++i) {
        if (seen[i]) continue;
        double sum = 0.0;
        seen[i] = true;
        open.push_back(i);
        while (!open.empty()) {
            const std::uint32_t at = open.back();
            open.pop_back();
            sum += interest(grid, walk.cells[at]);
            for_neighbours(grid, walk, at, [&](std::uint32_t next, const ivec3& /*step*/) {
                if (seen[next]) return;
                seen[next] = true;
                open.push_back(next);
            });
        }
        if (sum <= best) continue;
        best = sum;
        start = i;
    }
    return start;
}

/// From the cell furthest from anywhere to the cell furthest from that.
std::vector<ivec3> longest_way(const Occupancy& grid, const Walk& walk) {
    const std::uint32_t start = ways_from(grid, walk, best_space(grid, walk)).furthest;
    const Ways ways = ways_from(grid, walk, start);
    std::vector<ivec3> way;
    for (std::uint32_t at = ways.furthest; at != kUnset; at = ways.from[at])
        way.push_back(walk.cells[at]);
    return way;
}

/// Keys every eighth of the way, and more where the straight line between two would cut a corner.
void add_keys(const Occupancy& grid, const std::vector<ivec3>& way, std::size_t first,
              std::size_t last, std::size_t spacing, std::vector<vec3>& keys) {
    const bool straight = last - first <= spacing &&
                          grid.free_between(grid.centre_m(way[first]), grid.centre_m(way[last]));
    if (straight || last - first <= 1) {
        keys.push_back(grid.centre_m(way[last]));
        return;
    }
    const std::size_t middle = (first + last) / 2;
    add_keys(grid, way, first, middle, spacing, keys);
    add_keys(grid, way, middle, last, spacing, keys);
}

}  // namespace

std::optional<std::vector<CameraKey>> flight_through_rooms(const Occupancy& grid) {
    // As far from the walls as the rooms allow.
    Walk walk = walkable(grid, 2);
    for (const int clearance : {8, 6, 4, 3}) {
        Walk wide = walkable(grid, clearance);
        if (wide.cells.size() * 4 < walk.cells.size() || wide.cells.size() < 64) continue;
        walk = std::move(wide);
        break;
    }
    if (walk.cells.size() < 16) return std::nullopt;
    std::vector<ivec3> way = longest_way(grid, walk);
    // The last steps would end nose to wall.
    way.resize(way.size() - way.size() / 10);
    if (way.size() < 6) return std::nullopt;
    std::vector<vec3> points{grid.centre_m(way.front())};
    add_keys(grid, way, 0, way.size() - 1, std::max<std::size_t>(3, way.size() / 6), points);
    std::vector<CameraKey> keys;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const vec3& ahead = points[std::min(i + 2, points.size() - 1)];
        const vec3 target = i + 1 < points.size() ? ahead : points[i] + (points[i] - points[i - 1]);
        keys.push_back({points[i], target});
    }
    return keys;
}

std::optional<std::vector<CameraKey>> flight_before_stage(const Occupancy& grid,
                                                          const Bounds& bounds) {
    const vec3 extent_m = bounds.max_m - bounds.min_m;
    const vec3 centre_m = bounds.min_m + 0.5F * extent_m;
    const ivec3 centre = grid.cell_at(centre_m);
    if (grid.solid(centre)) return std::nullopt;
    vec3 open(0.0F);
    int open_sides = 0;
    for (const ivec3& side : {ivec3(1, 0, 0), ivec3(-1, 0, 0), ivec3(0, 0, 1), ivec3(0, 0, -1)}) {
        if (grid.look(centre, side).blocked) continue;
        open = vec3(side);
        ++open_sides;
    }
    if (open_sides != 1 || !grid.look(centre, ivec3(0, 1, 0)).blocked ||
        !grid.look(centre, ivec3(0, -1, 0)).blocked)
        return std::nullopt;
    const vec3 across = glm::cross(open, vec3(0.0F, 1.0F, 0.0F));
    const vec3 target_m = centre_m - 0.25F * extent_m * open - vec3(0.0F, 0.05F * extent_m.y, 0.0F);
    std::vector<CameraKey> keys;
    constexpr int kKeys = 8;
    for (int i = 0; i <= kKeys; ++i) {
        const auto angle = static_cast<float>(2.0 * std::numbers::pi * i / kKeys);
        const vec3 off_m = extent_m * (0.47F * open + 0.25F * std::sin(angle) * across +
                                       vec3(0.0F, 0.12F * std::sin(2.0F * angle), 0.0F));
        keys.push_back({centre_m + off_m, target_m});
        if (grid.solid(grid.cell_at(centre_m + off_m))) return std::nullopt;
    }
    return keys;
}

std::vector<CameraKey> flight_around(const Bounds& bounds) {
    const vec3 extent_m = bounds.max_m - bounds.min_m;
    const vec3 centre_m = bounds.min_m + 0.5F * extent_m;
    const float radius_m = 0.85F * glm::length(extent_m);
    std::vector<CameraKey> keys;
    constexpr int kKeys = 8;
    for (int i = 0; i <= kKeys; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kKeys;
        const vec3 off(static_cast<float>(std::sin(angle)), 0.35F,
                       static_cast<float>(std::cos(angle)));
        keys.push_back({centre_m + radius_m * glm::normalize(off), centre_m});
    }
    return keys;
}

}  // namespace foverig::scene_import
