#include "renderer/kernels/select_pixels.h"

#include "tests/house/device/launch.h"

using namespace foverig;
FOVERIG_LAUNCH(SelectPixels);
