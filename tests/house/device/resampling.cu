#include "renderer/kernels/resampling.h"

#include "tests/house/device/launch.h"

using namespace foverig;
FOVERIG_LAUNCH(ResolveCoarse);
FOVERIG_LAUNCH(MarkResampling);
