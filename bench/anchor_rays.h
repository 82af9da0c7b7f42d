#pragma once
// The rays of one tile as bare Embree loops read them: real rays only, in the order in which the
// renderer traces them.
#include <cstdint>
#include <vector>

#include "renderer/kernels/camera_rays.h"
#include "renderer/trace/ray.h"

namespace foverig::bench {

/// Sixteen rays in rows; t_min is 0. Lanes past the last ray have t_max < 0: nothing can be hit.
struct alignas(64) RayBlock {
    float org_x[16], org_y[16], org_z[16];
    float dir_x[16], dir_y[16], dir_z[16];
    float t_max[16];
};

/// Visibility rays, compacted: a ray of weight 0 is no ray.
class RayList {
  public:
    void add(const Ray& ray) {
        const auto lane = static_cast<std::size_t>(count_ % 16);
        if (lane == 0) blocks_.push_back(empty_block());
        RayBlock& b = blocks_.back();
        b.org_x[lane] = ray.origin_m.x;
        b.org_y[lane] = ray.origin_m.y;
        b.org_z[lane] = ray.origin_m.z;
        b.dir_x[lane] = ray.direction.x;
        b.dir_y[lane] = ray.direction.y;
        b.dir_z[lane] = ray.direction.z;
        b.t_max[lane] = ray.t_max;
        ++count_;
    }
    const std::vector<RayBlock>& blocks() const { return blocks_; }
    std::uint64_t count() const { return count_; }

  private:
    static RayBlock empty_block() {
        RayBlock b{};
        for (int i = 0; i < 16; ++i) {
            b.dir_z[i] = 1.0F;
            b.t_max[i] = -1.0F;
        }
        return b;
    }

    std::vector<RayBlock> blocks_;
    std::uint64_t count_ = 0;
};

/// Primary rays are made from the queue's pixels, as the renderer makes them: faster than loading
/// them.
struct PixelQueue {
    EyeRays eye;
    std::vector<PackedPixel> pixels;   ///< padded to whole packets by repeating the last
    std::vector<std::uint8_t> sparse;  ///< by pixel: outside r0 of a foveated frame; empty: none is
    int count = 0;
};

}  // namespace foverig::bench
