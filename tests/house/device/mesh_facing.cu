#include "renderer/kernels/mesh_facing.h"

#include "tests/house/device/launch.h"

using namespace foverig;
FOVERIG_LAUNCH(MeasureFacing);
