#include "renderer/kernels/depth_mesh.h"

#include "tests/house/device/launch.h"

using namespace foverig;
FOVERIG_LAUNCH(ReprojectVertices);
