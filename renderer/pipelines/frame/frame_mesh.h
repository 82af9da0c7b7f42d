#pragma once
// The depth mesh drawn over whole frames of all eyes in one list of launches. `Backend`: see
// frame_shading.h.
#include <algorithm>
#include <array>

#include "renderer/buffer.h"
#include "renderer/kernels/frame_eyes.h"
#include "renderer/kernels/frame_raster.h"

namespace foverig {

template <class Backend>
class FrameMesh {
    template <class T>
    using Array = typename Backend::template Array<T>;

  public:
    using Frames = std::array<RasterFrame, kMostEyes>;  ///< an eye each; their tile is not used

    /// Room for images of either size, one an eye; the mesh has a vertex for each pixel of
    /// `coarse`.
    void allocate(MemoryCount& memory, int eyes, const TileGrid& image, const TileGrid& coarse) {
        eyes_ = eyes;
        const auto count = static_cast<std::size_t>(eyes);
        const auto tiles = static_cast<std::size_t>(std::max(image.count(), coarse.count()));
        keys_each_ = tiles * kTilePixels;
        plane_ = tiles * kRasterTileFloats + kLanes;
        large_each_ = static_cast<std::size_t>(coarse.width_px * coarse.height_px) + 1;
        keys_ = {memory, count * keys_each_};
        planes_ = {memory, count * 4 * plane_};
        large_ = {memory, count * large_each_};
    }

    /// What was drawn last, from the first tile on.
    RasterTile tiles(std::size_t eye) {
        float* const p = planes_.data() + eye * 4 * plane_;
        return {p, p + plane_, p + 2 * plane_, p + 3 * plane_};
    }

    void draw(Backend& backend, const char* name, const TileGrid& grid, const Frames& frames) {
        clear(backend, name, grid);
        launch(backend, name, RasterCells::count(frames[0].mesh), [&](std::size_t eye) {
            return RasterCells{frames[eye], target(eye, grid)};
        });
        launch(backend, name, RasterLargeCells::count(grid), [&](std::size_t eye) {
            return RasterLargeCells{frames[eye], target(eye, grid)};
        });
        resolve(backend, name, grid, frames);
    }
    /// As if no cell could be seen.
    void draw_nothing(Backend& backend, const char* name, const TileGrid& grid,
                      const Frames& frames) {
        clear(backend, name, grid);
        resolve(backend, name, grid, frames);
    }

  private:
    template <class Make>
    void launch(Backend& backend, const char* name, int each, const Make& make) {
        using Kernel = decltype(make(std::size_t{0}));
        const auto last = static_cast<std::size_t>(eyes_ - 1);
        backend.launch(name, {each * eyes_}, EachEye<Kernel>{{make(0), make(last)}, each});
    }
    void clear(Backend& backend, const char* name, const TileGrid& grid) {
        launch(backend, name, ResolveRaster::count(grid),
               [&](std::size_t eye) { return ClearRaster{target(eye, grid)}; });
    }
    void resolve(Backend& backend, const char* name, const TileGrid& grid, const Frames& frames) {
        launch(backend, name, ResolveRaster::count(grid), [&](std::size_t eye) {
            return ResolveRaster{frames[eye], target(eye, grid).keys, tiles(eye), grid};
        });
    }
    FrameRaster target(std::size_t eye, const TileGrid& grid) {
        int* const list = large_.data() + eye * large_each_;
        return {keys_.data() + eye * keys_each_, list + 1, list, grid};
    }

    int eyes_ = 0;
    std::size_t keys_each_ = 0;
    std::size_t plane_ = 0;
    std::size_t large_each_ = 0;
    Array<RasterKey> keys_;
    Array<float> planes_;  ///< four an eye
    Array<int> large_;     ///< of an eye: a count, then cells
};

}  // namespace foverig
