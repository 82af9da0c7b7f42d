#pragma once
#include "metrics/tile.h"

namespace foverig::metrics {

/// The filters of FLIP at so many pixels per degree (Andersson et al. 2020, 4.1.1 and 4.2.1). Each
/// is a product of one along x and one along y, or the sum of two such.
struct FlipFilters {
    explicit FlipFilters(double pixels_per_degree);

    Taps achromatic, red_green;         ///< contrast sensitivity, the same along x and y
    Taps blue_yellow_1, blue_yellow_2;  ///< their two products are added
    Taps smooth, edge, point;  ///< features: edge or point along one axis, smooth the other
    int margin = 0;            ///< the largest reach
};

}  // namespace foverig::metrics
