#include "renderer/backends/embree/split_build.h"

#include <fmt/format.h>

#include <stdexcept>

#include "renderer/backends/embree/handles.h"

namespace foverig::embree {
namespace {

using Bvh = Owner<RTCBVH, rtcReleaseBVH>;

/// Spatial splits may make this many primitives of one, all in all.
constexpr std::size_t kCapacityFactor = 2;

struct Node {
    Node* children[2] = {nullptr, nullptr};
    Box box;  ///< of a leaf
    std::uint32_t primitive = 0;
};

void* make_node(RTCThreadLocalAllocator allocator, unsigned /*children*/, void* /*user*/) {
    return new (rtcThreadLocalAlloc(allocator, sizeof(Node), alignof(Node))) Node;
}

void* make_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitive,
                std::size_t /*count*/, void* /*user*/) {
    Node* const leaf = new (rtcThreadLocalAlloc(allocator, sizeof(Node), alignof(Node))) Node;
    leaf->box = {{primitive->lower_x, primitive->lower_y, primitive->lower_z},
                 {primitive->upper_x, primitive->upper_y, primitive->upper_z}};
    leaf->primitive = primitive->primID;
    return leaf;
}

void set_children(void* node, void** children, unsigned count, void* /*user*/) {
    for (unsigned i = 0; i < count; ++i)
        static_cast<Node*>(node)->children[i] = static_cast<Node*>(children[i]);
}

void ignore_bounds(void*, const RTCBounds**, unsigned, void*) {}

void store(const Box& box, RTCBounds& out) {
    out = {box.min_m.x, box.min_m.y, box.min_m.z, 0.0F,
           box.max_m.x, box.max_m.y, box.max_m.z, 0.0F};
}

Box common(const Box& a, const Box& b) {
    return {glm::max(a.min_m, b.min_m), glm::min(a.max_m, b.max_m)};
}

/// Boxes of a triangle's two sides of a plane, within the box that it already has.
void split(const RTCBuildPrimitive* primitive, unsigned axis, float at_m, RTCBounds* left,
           RTCBounds* right, void* user) {
    const Corners& corners = static_cast<const Corners*>(user)[primitive->primID];
    const int a = static_cast<int>(axis);
    Box below;
    Box above;
    for (std::size_t i = 0; i < 3; ++i) {
        const vec3& p = corners[i];
        const vec3& q = corners[(i + 1) % 3];
        if (p[a] <= at_m) below.grow(p);
        if (p[a] >= at_m) above.grow(p);
        if ((p[a] < at_m) == (q[a] < at_m) || p[a] == at_m || q[a] == at_m) continue;
        const double share = (double{at_m} - double{p[a]}) / (double{q[a]} - double{p[a]});
        vec3 cut(dvec3(p) + share * (dvec3(q) - dvec3(p)));
        cut[a] = at_m;
        below.grow(cut);
        above.grow(cut);
    }
    const Box whole{{primitive->lower_x, primitive->lower_y, primitive->lower_z},
                    {primitive->upper_x, primitive->upper_y, primitive->upper_z}};
    store(common(below, whole), *left);
    store(common(above, whole), *right);
}

/// Parents before children, the two of a node side by side; then boxes from the leaves upwards.
BinaryBvh flat(const Node* root) {
    BinaryBvh nodes(1);
    std::vector<std::pair<const Node*, std::uint32_t>> open{{root, 0U}};
    while (!open.empty()) {
        const auto [node, at] = open.back();
        open.pop_back();
        if (node->children[0] == nullptr) {
            nodes[at].box = node->box;
            nodes[at].primitive = node->primitive;
            continue;
        }
        const auto child = static_cast<std::uint32_t>(nodes.size());
        nodes[at].first_child = child;
        nodes.resize(nodes.size() + 2);
        open.emplace_back(node->children[1], child + 1);
        open.emplace_back(node->children[0], child);
    }
    for (std::size_t i = nodes.size(); i-- > 0;) {
        if (nodes[i].leaf()) continue;
        nodes[i].box.grow(nodes[nodes[i].first_child].box);
        nodes[i].box.grow(nodes[nodes[i].first_child + 1].box);
    }
    return nodes;
}

}  // namespace

BinaryBvh build_with_splits(std::span<const Corners> triangles, int threads) {
    if (triangles.empty()) return {};
    const Device device(
        rtcNewDevice(threads > 0 ? fmt::format("threads={}", threads).c_str() : nullptr));
    if (device.get() == nullptr)
        throw std::runtime_error("Embree has no device for this processor");
    const Bvh bvh(rtcNewBVH(device.get()));
    std::vector<RTCBuildPrimitive> primitives(triangles.size() * kCapacityFactor);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Box box = box_of(triangles[i]);
        primitives[i] = {box.min_m.x, box.min_m.y, box.min_m.z, 0U,
                         box.max_m.x, box.max_m.y, box.max_m.z, static_cast<unsigned>(i)};
    }
    RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.buildQuality = RTC_BUILD_QUALITY_HIGH;
    arguments.maxBranchingFactor = 2;
    arguments.maxDepth = 1024;
    arguments.sahBlockSize = 1;
    arguments.minLeafSize = 1;
    arguments.maxLeafSize = 1;
    arguments.bvh = bvh.get();
    arguments.primitives = primitives.data();
    arguments.primitiveCount = triangles.size();
    arguments.primitiveArrayCapacity = primitives.size();
    arguments.createNode = make_node;
    arguments.setNodeChildren = set_children;
    arguments.setNodeBounds = ignore_bounds;
    arguments.createLeaf = make_leaf;
    arguments.splitPrimitive = split;
    arguments.userPtr = const_cast<Corners*>(triangles.data());
    const auto* const root = static_cast<const Node*>(rtcBuildBVH(&arguments));
    if (root == nullptr)
        throw std::runtime_error(fmt::format("Embree could not build over {} triangles: error {}",
                                             triangles.size(),
                                             static_cast<int>(rtcGetDeviceError(device.get()))));
    return flat(root);
}

}  // namespace foverig::embree
