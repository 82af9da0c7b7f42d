#include "metrics/tile.h"

namespace foverig::metrics {
namespace {

constexpr int kBlock = 32;  // sums that stay in registers

/// out[x] (+)= sum of taps[k] * in[k * step + x] over a row of the tile.
template <bool kAdd>
void correlate(const float* in, int step, const Taps& taps, float* out) {
    for (int x = 0; x < kTileWidth; x += kBlock) {
        float sums[kBlock];
        for (int i = 0; i < kBlock; ++i) sums[i] = kAdd ? out[x + i] : 0.0F;
        const float* from = in + x;
        for (const float tap : taps) {
            for (int i = 0; i < kBlock; ++i) sums[i] += tap * from[i];
            from += step;
        }
        for (int i = 0; i < kBlock; ++i) out[x + i] = sums[i];
    }
}

}  // namespace

void filter_rows(const WideTile& in, const Taps& taps, TallTile& out) {
    for (int y = 0; y < in.rows; ++y)
        correlate<false>(in.row(y) + in.margin - reach_of(taps), 1, taps, out.row(y));
}

void filter_columns(const TallTile& in, const Taps& taps, TilePlane& out, bool add) {
    for (int y = 0; y < kTileHeight; ++y) {
        const float* first = in.row(y + in.margin - reach_of(taps));
        float* row = out.data() + y * kTileWidth;
        if (add)
            correlate<true>(first, kTileWidth, taps, row);
        else
            correlate<false>(first, kTileWidth, taps, row);
    }
}

}  // namespace foverig::metrics
