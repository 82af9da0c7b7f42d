#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/vec.h"

namespace foverig::scene_import {

/// Splits polygons into triangles: by ear clipping in the polygon's best plane, which is right for
/// concave ones too. Where that finds no ear (self-crossing, folded) or would cost too much over
/// the whole file, the rest is a fan.
class Triangulator {
  public:
    /// Appends triangles as indices into `corners` (positions of one polygon, in order).
    void triangulate(std::span<const dvec3> corners, std::vector<uvec3>& triangles);

  private:
    void clip_ears(std::span<const dvec2> corners, std::vector<uvec3>& triangles);

    /// Point-in-triangle tests still allowed; clipping is cubic at worst.
    std::int64_t budget_ = 200'000'000;
};

}  // namespace foverig::scene_import
