#include "renderer/kernels/lens_distortion.h"

#include "tests/house/device/launch.h"

using namespace foverig;
FOVERIG_LAUNCH(DistortRow);
