#include "renderer/kernels/light_rays.h"

#include "tests/house/device/launch.h"

using namespace foverig;
FOVERIG_VISIBLE(PointLightRays, StoreVisible);
FOVERIG_LAUNCH(AddPointLight);
FOVERIG_VISIBLE(AreaLightRays, AddAreaLight);
FOVERIG_VISIBLE(OcclusionRays, StoreOcclusion);
