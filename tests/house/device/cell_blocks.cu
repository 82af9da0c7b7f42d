#include "renderer/kernels/cell_blocks.h"

#include "tests/house/device/launch.h"

namespace foverig::device {

__global__ void find_blocks(CellBlocks blocks, TileRange range, std::uint8_t* flags, int* found) {
    visit_blocks(blocks, range, flags, [&](int block) { *found++ = block; });
}

}  // namespace foverig::device

using namespace foverig;
FOVERIG_LAUNCH(BoundBlocks);
