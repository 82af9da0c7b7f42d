#include "renderer/kernels/reproject_pixels.h"

#include "tests/house/device/launch.h"

using namespace foverig;
FOVERIG_LAUNCH(ReprojectPixels<1, false>);
FOVERIG_LAUNCH(ReprojectPixels<2, false>);
FOVERIG_LAUNCH(ReprojectPixels<4, true>);
FOVERIG_LAUNCH(ReprojectPixels<8, true>);
