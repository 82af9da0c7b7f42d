#pragma once
// Parts of an image that stay in cache while they are filtered, with as much around them as the
// filters reach.
#include <algorithm>
#include <vector>

namespace foverig::metrics {

inline constexpr int kTileWidth = 256, kTileHeight = 64;

/// One number a pixel of a tile, rows of kTileWidth; the last tiles of an image have columns and
/// rows that belong to no pixel.
using TilePlane = std::vector<float>;

/// The taps of one direction of a separable filter: an odd number, the middle one at 0.
using Taps = std::vector<float>;

inline int reach_of(const Taps& taps) {
    return static_cast<int>(taps.size()) / 2;
}

/// A plane with `margin` more on each side than the tile.
struct WideTile {
    explicit WideTile(int margin_)
        : margin(margin_),
          stride(kTileWidth + 2 * margin_),
          rows(kTileHeight + 2 * margin_),
          values(static_cast<std::size_t>(stride) * static_cast<std::size_t>(rows)) {}

    float* row(int y) { return values.data() + y * stride; }
    const float* row(int y) const { return values.data() + y * stride; }

    int margin, stride, rows;
    std::vector<float> values;
};

/// A plane with the margin above and below only: what a filter along the rows leaves.
struct TallTile {
    explicit TallTile(int margin_)
        : margin(margin_),
          rows(kTileHeight + 2 * margin_),
          values(std::size_t{kTileWidth} * static_cast<std::size_t>(rows)) {}

    float* row(int y) { return values.data() + y * kTileWidth; }
    const float* row(int y) const { return values.data() + y * kTileWidth; }

    int margin, rows;
    std::vector<float> values;
};

/// Correlates rows with `taps`, whose reach is at most the margin.
void filter_rows(const WideTile& in, const Taps& taps, TallTile& out);

/// Correlates columns with `taps`, and adds to `out` if told to.
void filter_columns(const TallTile& in, const Taps& taps, TilePlane& out, bool add = false);

}  // namespace foverig::metrics
