#include "renderer/trace/refit.h"

#include "renderer/trace/quantise.h"
#include "tests/house/device/launch.h"

using namespace foverig;
FOVERIG_LAUNCH(MoveTriangles);
FOVERIG_LAUNCH(RefitNodes);
FOVERIG_LAUNCH(PlaceUpperNodes);
