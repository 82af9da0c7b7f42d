#include "renderer/kernels/frame_raster.h"

#include "tests/house/device/launch.h"

using namespace foverig;
FOVERIG_LAUNCH(ClearRaster);
FOVERIG_LAUNCH(RasterCells);
FOVERIG_LAUNCH(RasterLargeCells);
FOVERIG_LAUNCH(ResolveRaster);
