#include "renderer/kernels/post_process.h"

#include "tests/house/device/launch.h"

using namespace foverig;
FOVERIG_LAUNCH(PostProcess<false>);
FOVERIG_LAUNCH(PostProcess<true>);
