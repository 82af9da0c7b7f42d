#include "renderer/kernels/path_rays.h"

#include "renderer/kernels/path_sampling.h"
#include "renderer/kernels/path_state.h"
#include "tests/house/device/launch.h"

using namespace foverig;
FOVERIG_LAUNCH(BeginPaths);
FOVERIG_CLOSEST(PathRays, StoreHit);
FOVERIG_VISIBLE(PathAreaLightRays, AddAreaLight);
FOVERIG_VISIBLE(PathOcclusionRays, StoreOcclusion);
