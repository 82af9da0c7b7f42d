#include "renderer/kernels/camera_rays.h"

#include "tests/house/device/launch.h"

using namespace foverig;
FOVERIG_CLOSEST(CameraRays, StoreHit);
