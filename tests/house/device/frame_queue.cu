#include "renderer/kernels/frame_queue.h"

#include "tests/house/device/launch.h"

using namespace foverig;
FOVERIG_LAUNCH(QueuePixels);

namespace foverig::device {

template <class Keep, class OnPlace>
__global__ void number(Keep keep, OnPlace on_place, int n) {
    if (index() < n) on_place(index(), keep(index()) ? index() : -1);
}

template __global__ void number(SeesSurface, GiveSlot, int);
template __global__ void number(IsChosen, QueueSample, int);

}  // namespace foverig::device
