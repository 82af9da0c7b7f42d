#pragma once
#include <array>

#include "renderer/effects/memory.h"
#include "renderer/kernels/pixel.h"
#include "renderer/kernels/surface.h"
#include "renderer/kernels/tile_grid.h"
#include "renderer/view.h"

namespace foverig {

/// The order in which a tile's surfaces send occlusion rays. Rays scatter over the hemisphere, so
/// only those of equal local direction and similar origin and normal are fit to share a packet.
class OcclusionQueue {
  public:
    struct Part {
        View<const int> slots;     ///< surface of each place
        View<const int> patterns;  ///< which run of the sequence it uses
    };

    /// Holds nothing where occlusion is off.
    OcclusionQueue(EffectMemory& memory, const EffectPlan& plan);

    /// Queues the first `n` pixels that have a surface. Dense ones, all of whose neighbours are
    /// traced, are sorted by the pattern that belongs to the pixel. Sparse ones (`sparse` of a
    /// pixel is 1; null: none is) lie too far apart for that: sixteen of similar normal and depth
    /// take one pattern, drawn anew each frame, and the sixteen among them another.
    void order(const Surfaces& surfaces, View<const PackedPixel> pixels,
               View<const std::uint32_t> slots, const std::uint8_t* sparse, int n,
               std::uint32_t seed);

    Part dense() const { return part(0, dense_); }
    Part sparse() const { return part(dense_, count_ - dense_); }

  private:
    Part part(int first, int n) const;
    void interleave_sparse(std::uint32_t seed);

    Buffer<int> slots_;
    Buffer<int> patterns_;
    Buffer<std::uint16_t> keys_;
    int dense_ = 0;
    int count_ = 0;
};

}  // namespace foverig
