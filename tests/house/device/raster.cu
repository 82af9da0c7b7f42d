#include "renderer/kernels/raster.h"

#include "tests/house/device/launch.h"

namespace foverig::device {

__global__ void draw_blocks(RasterFrame frame, RasterTile tile, const int* rows, const int* columns,
                            int n) {
    for (int i = 0; i < n; ++i) raster_block(frame, tile, rows[i], columns[i]);
}

}  // namespace foverig::device
