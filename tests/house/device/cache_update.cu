#include "renderer/kernels/cache_update.h"

#include "tests/house/device/launch.h"

using namespace foverig;
FOVERIG_LAUNCH(CacheUpdate<false, false, false>);
FOVERIG_LAUNCH(CacheUpdate<false, false, true>);
FOVERIG_LAUNCH(CacheUpdate<false, true, false>);
FOVERIG_LAUNCH(CacheUpdate<false, true, true>);
FOVERIG_LAUNCH(CacheUpdate<true, true, false>);
FOVERIG_LAUNCH(CacheUpdate<true, true, true>);
