#include "renderer/trace/traverse.h"

#include "renderer/trace/box.h"
#include "renderer/trace/byte_lanes.h"
#include "renderer/trace/node_test.h"
#include "renderer/trace/packed_bvh.h"
#include "renderer/trace/ray_triangle.h"
#include "renderer/trace/slab_frame.h"
#include "renderer/trace/triple.h"
#include "tests/house/device/launch.h"

namespace foverig::device {

/// The contract of DESIGN.md's closest and occluded passes, one ray a thread.
template <bool kAny, bool kAlpha>
__global__ void trace(BvhView bvh, SceneView scene, const Ray* rays, Hit* hits, int n) {
    if (index() < n) hits[index()] = traverse<kAny, kAlpha>(bvh, scene, rays[index()]);
}

template __global__ void trace<false, false>(BvhView, SceneView, const Ray*, Hit*, int);
template __global__ void trace<false, true>(BvhView, SceneView, const Ray*, Hit*, int);
template __global__ void trace<true, false>(BvhView, SceneView, const Ray*, Hit*, int);
template __global__ void trace<true, true>(BvhView, SceneView, const Ray*, Hit*, int);

}  // namespace foverig::device
