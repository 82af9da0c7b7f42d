#include "renderer/kernels/merge.h"

#include "tests/house/device/launch.h"

using namespace foverig;
FOVERIG_LAUNCH(MergeSupport<false>);
FOVERIG_LAUNCH(MergeSupport<true>);
