#include "renderer/scene/occupancy.h"

#include <algorithm>
#include <cmath>

namespace foverig::scene_import {

namespace {

/// Samples that a scene may cost; a million triangles across the whole of it get coarser ones.
inline constexpr double kMostSamples = 2.0e7;

float longest_edge_m(const vec3& a, const vec3& b, const vec3& c) {
    const vec3 u = b - a;
    const vec3 v = c - a;
    const vec3 w = c - b;
    return std::sqrt(std::max({glm::dot(u, u), glm::dot(v, v), glm::dot(w, w)}));
}

/// Spacing of samples: half a cell, or more where that would be too many.
float spacing_m(const Scene& scene, float cell_m) {
    double samples = 0.0;
    for (const uvec3& t : scene.triangles) {
        const float steps =
            2.0F *
            longest_edge_m(scene.positions_m[t.x], scene.positions_m[t.y], scene.positions_m[t.z]) /
            cell_m;
        samples += 0.5 * double{steps} * double{steps};
    }
    return 0.5F * cell_m * static_cast<float>(std::sqrt(std::max(1.0, samples / kMostSamples)));
}

}  // namespace

Occupancy::Occupancy(const Scene& scene) {
    const vec3 extent_m = scene.bounds.max_m - scene.bounds.min_m;
    cell_m_ = std::max({extent_m.x, extent_m.y, extent_m.z}) / kCells;
    // A margin of one free cell all round, so that walls on the bounds have an outside.
    size_ = ivec3(glm::floor(extent_m / cell_m_)) + 3;
    size_ = glm::min(size_, ivec3(kCells + 3));
    min_m_ = scene.bounds.min_m - cell_m_;
    hits_.assign(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) *
                     static_cast<std::size_t>(size_.z),
                 0);
    normals_.assign(hits_.size(), vec3(0.0F));
    const float apart_m = spacing_m(scene, cell_m_);
    for (const uvec3& t : scene.triangles)
        add_triangle(scene.positions_m[t.x], scene.positions_m[t.y], scene.positions_m[t.z],
                     apart_m);
    measure_clearance();
}

void Occupancy::add_triangle(const vec3& a, const vec3& b, const vec3& c, float apart_m) {
    const vec3 u = b - a;
    const vec3 v = c - a;
    const float longest_m = longest_edge_m(a, b, c);
    // The sign is what counts; scaling by the cell keeps the product of small edges above zero.
    const vec3 normal = glm::cross(u / cell_m_, v / cell_m_);
    const float length = glm::length(normal);
    const vec3 unit = length > 0.0F ? normal / length : vec3(0.0F);
    if (longest_m < 0.75F * cell_m_) {
        add_sample(a + (u + v) * (1.0F / 3.0F), unit);
        return;
    }
    const int steps = static_cast<int>(longest_m / apart_m) + 1;
    const float step = 1.0F / static_cast<float>(steps);
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; i + j <= steps; ++j)
            add_sample(a + u * (static_cast<float>(i) * step) + v * (static_cast<float>(j) * step),
                       unit);
}

void Occupancy::add_sample(const vec3& position_m, const vec3& normal) {
    const ivec3 cell = cell_at(position_m);
    if (!inside(cell)) return;
    const std::size_t at = index(cell);
    ++hits_[at];
    normals_[at] += normal;
}

bool Occupancy::inside(const ivec3& cell) const {
    return cell.x >= 0 && cell.y >= 0 && cell.z >= 0 && cell.x < size_.x && cell.y < size_.y &&
           cell.z < size_.z;
}

Occupancy::Sight Occupancy::look(const ivec3& from, const ivec3& direction) const {
    Sight sight;
    for (ivec3 cell = from + direction; inside(cell); cell += direction) {
        if (solid(cell)) {
            sight.blocked = true;
            sight.detail = hits_[index(cell)];
            sight.front = glm::dot(normals_[index(cell)], vec3(direction)) < 0.0F;
            return sight;
        }
        ++sight.cells;
    }
    return sight;
}

bool Occupancy::free_between(const vec3& from_m, const vec3& to_m) const {
    const int steps = static_cast<int>(glm::length(to_m - from_m) / (0.25F * cell_m_)) + 1;
    for (int i = 0; i <= steps; ++i) {
        const ivec3 cell =
            cell_at(glm::mix(from_m, to_m, static_cast<float>(i) / static_cast<float>(steps)));
        if (inside(cell) && solid(cell)) return false;
    }
    return true;
}

/// Chessboard distance by two sweeps, each of which looks at the 13 neighbours it has already
/// passed. The outermost cells are margin and keep the largest value.
void Occupancy::measure_clearance() {
    clearance_.assign(hits_.size(), 255);
    for (std::size_t i = 0; i < hits_.size(); ++i)
        if (hits_[i] > 0) clearance_[i] = 0;
    std::array<std::ptrdiff_t, 13> passed{};
    for (int i = 0; i < 13; ++i)
        passed[static_cast<std::size_t>(i)] =
            (std::ptrdiff_t{i / 9 - 1} * size_.z + (i / 3 % 3 - 1)) * size_.x + (i % 3 - 1);
    const auto relax = [&](const ivec3& cell, std::ptrdiff_t sign) {
        int* least = clearance_.data() + index(cell);
        for (const std::ptrdiff_t step : passed) *least = std::min(*least, least[sign * step] + 1);
    };
    const ivec3 last = size_ - 2;
    for (int y = 1; y <= last.y; ++y)
        for (int z = 1; z <= last.z; ++z)
            for (int x = 1; x <= last.x; ++x) relax(ivec3(x, y, z), 1);
    for (int y = last.y; y >= 1; --y)
        for (int z = last.z; z >= 1; --z)
            for (int x = last.x; x >= 1; --x) relax(ivec3(x, y, z), -1);
}

bool Occupancy::in_room(const ivec3& cell) const {
    if (solid(cell)) return false;
    int open = 0;
    int front = 0;
    for (const ivec3& direction : {ivec3(1, 0, 0), ivec3(-1, 0, 0), ivec3(0, 1, 0), ivec3(0, -1, 0),
                                   ivec3(0, 0, 1), ivec3(0, 0, -1)}) {
        const Sight sight = look(cell, direction);
        open += sight.blocked ? 0 : 1;
        front += sight.front ? 1 : 0;
        if (open > 1) return false;
    }
    return front >= 3;
}

double Occupancy::room_share() const {
    std::size_t free = 0;
    std::size_t rooms = 0;
    // Every second cell each way: a share needs no more.
    for (int y = 0; y < size_.y; y += 2)
        for (int z = 0; z < size_.z; z += 2)
            for (int x = 0; x < size_.x; x += 2) {
                const ivec3 cell(x, y, z);
                free += solid(cell) ? 0 : 1;
                rooms += in_room(cell) ? 1 : 0;
            }
    return free == 0 ? 0.0 : static_cast<double>(rooms) / static_cast<double>(free);
}

}  // namespace foverig::scene_import
