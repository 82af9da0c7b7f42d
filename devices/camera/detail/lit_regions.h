#pragma once
// Connected regions (8 neighbours) of pixels above a threshold, by runs of rows.
#include <vector>

#include "devices/camera/frame.h"

namespace foverig::camera::detail {

/// Box inclusive.
struct Region {
    int left = 0, right = 0, top = 0, bottom = 0, area_px = 0, peak = 0;
};

/// In the order of their first pixels, row by row.
std::vector<Region> lit_regions(const GreyView& image, int threshold);

}  // namespace foverig::camera::detail
