#include "renderer/kernels/path_vertex.h"

#include "tests/house/device/launch.h"

using namespace foverig;
FOVERIG_LAUNCH(ShadeVertex<false, false, false>);
FOVERIG_LAUNCH(ShadeVertex<true, true, true>);
FOVERIG_LAUNCH(GatherMisses);
FOVERIG_LAUNCH(LeaveVertex<false, false>);
FOVERIG_LAUNCH(LeaveVertex<false, true>);
FOVERIG_LAUNCH(LeaveVertex<true, true>);
FOVERIG_LAUNCH(AccumulatePaths);
