#include "metrics/flip.h"

#include <tbb/blocked_range2d.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "metrics/display_code.h"
#include "metrics/flip_colour.h"
#include "metrics/flip_filters.h"

namespace foverig::metrics {
namespace {

/// What one image is to FLIP at the pixels of one tile.
struct SeenTile {
    TilePlane lightness, a, b;
    TilePlane edge, point;

    SeenTile() {
        for (TilePlane* plane : {&lightness, &a, &b, &edge, &point})
            plane->resize(std::size_t{kTileWidth} * kTileHeight);
    }
};

/// Makes a SeenTile; holds the room that this takes, so one for each thread.
class TileEye {
  public:
    explicit TileEye(const FlipFilters& filters)
        : filters_(filters),
          y_(filters.margin),
          cx_(y_),
          cz_(y_),
          rows_(filters.margin),
          smooth_rows_(rows_) {
        along_y_.resize(std::size_t{kTileWidth} * kTileHeight);
    }

    void see(const Image& image, int x0, int y0, SeenTile& seen) {
        load(image, x0, y0);
        filter_colours(seen);
        filter_rows(y_, filters_.smooth, smooth_rows_);
        filter_features(filters_.edge, seen.edge);
        filter_features(filters_.point, seen.point);
    }

  private:
    /// Beyond the image its outermost pixels go on.
    void load(const Image& image, int x0, int y0) {
        const int margin = filters_.margin;
        const int inside_begin = std::max(0, margin - x0);
        const int inside_end = std::min(y_.stride, image.width_px - x0 + margin);
        for (int row = 0; row < y_.rows; ++row) {
            const int y = std::clamp(y0 + row - margin, 0, image.height_px - 1);
            float* out_y = y_.row(row);
            float* out_cx = cx_.row(row);
            float* out_cz = cz_.row(row);
            const vec3* in = &image.at(0, y);
            const int shift = x0 - margin;
            for (int i = inside_begin; i < inside_end; ++i) {
                const vec3& p = in[i + shift];
                const Opponent o = opponent_of({clamped(p.x), clamped(p.y), clamped(p.z)});
                out_y[i] = o.y;
                out_cx[i] = o.cx;
                out_cz[i] = o.cz;
            }
            for (float* out : {out_y, out_cx, out_cz}) {
                std::fill(out, out + inside_begin, out[inside_begin]);
                std::fill(out + inside_end, out + y_.stride, out[inside_end - 1]);
            }
        }
    }

    void filter(const WideTile& in, const Taps& taps, TilePlane& out, bool add = false) {
        filter_rows(in, taps, rows_);
        filter_columns(rows_, taps, out, add);
    }

    void filter_colours(SeenTile& seen) {
        filter(y_, filters_.achromatic, seen.lightness);
        filter(cx_, filters_.red_green, seen.a);
        filter(cz_, filters_.blue_yellow_1, seen.b);
        filter(cz_, filters_.blue_yellow_2, seen.b, true);
        for (std::size_t i = 0; i < seen.a.size(); ++i) {
            const vec3 lab = hunt_lab_of(rgb_of({seen.lightness[i], seen.a[i], seen.b[i]}));
            seen.lightness[i] = lab.x;
            seen.a[i] = lab.y;
            seen.b[i] = lab.z;
        }
    }

    /// Length of the gradient of one kind of feature.
    void filter_features(const Taps& taps, TilePlane& out) {
        filter_columns(smooth_rows_, taps, along_y_);
        filter_rows(y_, taps, rows_);
        filter_columns(rows_, filters_.smooth, out);
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i] = std::sqrt(out[i] * out[i] + along_y_[i] * along_y_[i]);
    }

    const FlipFilters& filters_;
    WideTile y_, cx_, cz_;
    TallTile rows_, smooth_rows_;
    TilePlane along_y_;
};

/// Colours that differ count for more where edges or points do too.
float combined(float colour, float edge_difference, float point_difference) {
    const float feature = std::max(std::abs(edge_difference), std::abs(point_difference));
    return power_of(colour, 1.0F - std::sqrt(feature * 0.707106781F));
}

struct Workplace {
    explicit Workplace(const FlipFilters& filters) : eye(filters) {}

    TileEye eye;
    SeenTile a, b;
};

void write_errors(const SeenTile& a, const SeenTile& b, int x0, int y0, Plane& errors) {
    const int columns = std::min(kTileWidth, errors.width_px - x0);
    const int rows = std::min(kTileHeight, errors.height_px - y0);
    for (int y = 0; y < rows; ++y) {
        float* out = errors.row(y0 + y) + x0;
        const std::size_t first = static_cast<std::size_t>(y) * kTileWidth;
        for (int x = 0; x < columns; ++x) {
            const std::size_t i = first + static_cast<std::size_t>(x);
            const float colour =
                colour_error({a.lightness[i], a.a[i], a.b[i]}, {b.lightness[i], b.a[i], b.b[i]});
            out[x] = combined(colour, a.edge[i] - b.edge[i], a.point[i] - b.point[i]);
        }
    }
}

int tiles_of(int pixels, int tile) {
    return (pixels + tile - 1) / tile;
}

}  // namespace

Plane flip(const Image& a, const Image& b, double pixels_per_degree) {
    check_same_size(a, b);
    const FlipFilters filters(pixels_per_degree);
    Plane errors(a.width_px, a.height_px);
    tbb::enumerable_thread_specific<Workplace> workplaces([&] { return Workplace(filters); });
    const tbb::blocked_range2d<int> tiles(0, tiles_of(a.height_px, kTileHeight), 1, 0,
                                          tiles_of(a.width_px, kTileWidth), 1);
    tbb::parallel_for(tiles, [&](const tbb::blocked_range2d<int>& range) {
        Workplace& work = workplaces.local();
        for (int row = range.rows().begin(); row < range.rows().end(); ++row)
            for (int column = range.cols().begin(); column < range.cols().end(); ++column) {
                const int x0 = column * kTileWidth;
                const int y0 = row * kTileHeight;
                work.eye.see(a, x0, y0, work.a);
                work.eye.see(b, x0, y0, work.b);
                write_errors(work.a, work.b, x0, y0, errors);
            }
    });
    return errors;
}

}  // namespace foverig::metrics
