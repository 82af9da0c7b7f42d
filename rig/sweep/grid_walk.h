#pragma once
// A sweep's points as the grid that they are.
#include "rig/sweep/definition.h"
#include "rig/sweep/search.h"

namespace foverig::sweep {

class GridWalk {
  public:
    /// Throws UsageError where the sweep's points are no grid: a knob that is a range, or a Latin
    /// hypercube; and where the numbers of a knob go up and down, as steps lead nowhere then.
    explicit GridWalk(const Sweep& sweep);

    const std::vector<std::size_t>& sizes() const { return sizes_; }
    /// Of places.
    std::size_t count() const;
    /// The base, or where it is not on the grid the nearest values to its own.
    GridPlace start() const;
    /// Of the sweep's points.
    std::size_t point_at(const GridPlace& place) const;

  private:
    bool holds_all() const;

    const Sweep& sweep_;
    std::vector<std::size_t> sizes_;
    std::size_t first_ = 0;  ///< the base stands before the grid where the grid does not meet it
};

}  // namespace foverig::sweep
