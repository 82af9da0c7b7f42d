#include "renderer/kernels/frame_spans.h"

#include "renderer/kernels/cache_update.h"
#include "renderer/kernels/frame_eyes.h"
#include "renderer/kernels/merge.h"
#include "renderer/kernels/resampling.h"
#include "renderer/kernels/select_pixels.h"
#include "renderer/kernels/tile_grid.h"
#include "tests/house/device/launch.h"

using namespace foverig;
FOVERIG_LAUNCH(EachEye<RowSpans<MarkResampling>>);
FOVERIG_LAUNCH(EachEye<TileSpans<SelectPixels>>);
FOVERIG_LAUNCH(EachEye<TileSpans<MergeSupport<true>>>);
FOVERIG_LAUNCH(EyeOfPixel<InTileOfSample<CacheUpdate<true, true, false>>>);
