#include "renderer/kernels/alpha_test.h"

#include "tests/house/device/launch.h"

namespace foverig::device {

__global__ void ask_holes(SceneView scene, const Hit* hits, bool* holes, int n) {
    if (index() >= n) return;
    const Hit& hit = hits[index()];
    holes[index()] = is_hole(scene, hit.triangle, hit.u, hit.v);
}

}  // namespace foverig::device
