#include "renderer/kernels/samples.h"

#include "tests/house/device/launch.h"

using namespace foverig;
FOVERIG_LAUNCH(StoreSamples<false, false>);
FOVERIG_LAUNCH(StoreSamples<false, true>);
FOVERIG_LAUNCH(StoreSamples<true, true>);
