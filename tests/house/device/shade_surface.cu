#include "renderer/kernels/shade_surface.h"

#include "tests/house/device/launch.h"

using namespace foverig;
FOVERIG_LAUNCH(ShadeSurface<false, false, false>);
FOVERIG_LAUNCH(ShadeSurface<false, false, true>);
FOVERIG_LAUNCH(ShadeSurface<false, true, true>);
FOVERIG_LAUNCH(ShadeSurface<true, false, false>);
FOVERIG_LAUNCH(ShadeSurface<true, false, true>);
FOVERIG_LAUNCH(ShadeSurface<true, true, true>);
