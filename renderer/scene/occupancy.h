#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "renderer/scene/scene.h"

namespace foverig::scene_import {

using glm::ivec3;

/// An Occupancy::room_share above this means a scene to be in, not one to look at.
inline constexpr double kRoomShare = 0.2;

/// A coarse grid of which cells hold surface, to find free space for cameras and lights in a scene
/// that nobody described. Cells are cubes, `kCells` along the longest side.
class Occupancy {
  public:
    static constexpr int kCells = 64;

    /// What a ray along the grid met.
    struct Sight {
        int cells = 0;             ///< free cells passed
        bool blocked = false;      ///< by surface; else it left the grid
        bool front = false;        ///< the surface faces the ray's origin
        std::uint32_t detail = 0;  ///< samples of surface in that cell: more for fine geometry
    };

    explicit Occupancy(const Scene& scene);

    const ivec3& size() const { return size_; }
    float cell_m() const { return cell_m_; }
    bool inside(const ivec3& cell) const;
    bool solid(const ivec3& cell) const { return hits_[index(cell)] > 0; }
    vec3 centre_m(const ivec3& cell) const { return min_m_ + (vec3(cell) + 0.5F) * cell_m_; }
    ivec3 cell_at(const vec3& position_m) const {
        return ivec3(glm::floor((position_m - min_m_) * (1.0F / cell_m_)));
    }

    /// Steps of one cell in a direction of -1, 0, 1 each.
    Sight look(const ivec3& from, const ivec3& direction) const;

    /// Whether the straight line between two points passes free cells only.
    bool free_between(const vec3& from_m, const vec3& to_m) const;

    /// Cells to the nearest surface by the largest coordinate: 0 in a solid cell.
    int clearance(const ivec3& cell) const { return clearance_[index(cell)]; }

    /// Free, walled in on at least 5 of 6 sides, and not the hollow inside of a closed object.
    bool in_room(const ivec3& cell) const;

    /// Share of the free cells that are in_room. Measured: 0.3 to 0.9 for rooms and courts, below
    /// 0.06 for objects and towns.
    double room_share() const;

    std::size_t index(const ivec3& cell) const {
        return (static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(size_.z) +
                static_cast<std::size_t>(cell.z)) *
                   static_cast<std::size_t>(size_.x) +
               static_cast<std::size_t>(cell.x);
    }
    std::size_t cell_count() const { return hits_.size(); }

  private:
    void add_triangle(const vec3& a, const vec3& b, const vec3& c, float apart_m);
    void measure_clearance();
    void add_sample(const vec3& position_m, const vec3& normal);

    vec3 min_m_{0.0F};
    float cell_m_ = 1.0F;
    ivec3 size_{1};
    std::vector<std::uint32_t> hits_;  ///< surface samples in the cell
    std::vector<vec3> normals_;        ///< their summed unit normals
    std::vector<int> clearance_;
};

}  // namespace foverig::scene_import
