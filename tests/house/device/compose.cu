#include "renderer/kernels/compose.h"

#include "tests/house/device/launch.h"

using namespace foverig;
FOVERIG_LAUNCH(ComposePixels<false, false>);
FOVERIG_LAUNCH(ComposePixels<false, true>);
FOVERIG_LAUNCH(ComposePixels<true, true>);
