#pragma once
#include "renderer/backends/cuda/device_array.cuh"
#include "renderer/backends/cuda/pinned_array.cuh"
#include "renderer/backends/cuda/queue_kernels.cuh"
#include "renderer/trace/build/moved_parts.h"

namespace foverig::cuda {

/// Device copies of the arrays of a SceneView and a BvhView, and their motion: a frame's `stage`
/// runs on the host, its `upload` and `refit` in a stream. Both only enqueue, from and to the same
/// addresses at each call, and nothing in view() changes: they may be captured into a graph, which
/// then takes whatever was staged before its launch. All memory is taken by the constructor.
class DeviceScene {
  public:
    /// Has copied everything on return. `plan` (SceneBvh::plan) says what can move; without one
    /// nothing can, and the calls below do nothing.
    DeviceScene(MemoryCount& count, const SceneView& scene, const BvhView& bvh, cudaStream_t stream,
                const RefitPlan& plan = {});

    const TracedView& view() const { return view_; }
    bool moves() const { return plan_.moves(); }

    /// Packs the moving parts' vertices, normals and upper tree of `posed`, a view of the same
    /// PosedScene at another time. The upload before it must be over: wait for the last frame.
    void stage(const SceneView& posed);
    void upload(cudaStream_t stream);  ///< what was staged
    void refit(cudaStream_t stream);   ///< triangles, then nodes level by level, then upper tree
    /// All three, for frames that are no graph.
    void move(const SceneView& posed, cudaStream_t stream);

    /// As a refit left them, for whoever compares with the host's. Wait for the stream.
    std::vector<WideNode> nodes(cudaStream_t stream) const { return nodes_.download(stream); }
    std::vector<PackedTriangle> packed_triangles(cudaStream_t stream) const {
        return packed_triangles_.download(stream);
    }

  private:
    DeviceArray<vec3> positions_m_;
    DeviceArray<vec3> normals_;
    DeviceArray<vec2> texcoords_;
    DeviceArray<uvec3> triangles_;
    DeviceArray<std::uint16_t> triangle_materials_;
    DeviceArray<float> texel_density_log2_;
    DeviceArray<Material> materials_;
    DeviceArray<Texture> textures_;
    DeviceArray<std::uint32_t> texels_;
    DeviceArray<Half4> linear_texels_;
    DeviceArray<MipLevel> mips_;
    DeviceArray<PointLight> point_lights_;
    DeviceArray<AreaLight> area_lights_;
    DeviceArray<WideNode> nodes_;
    DeviceArray<PackedTriangle> packed_triangles_;
    TracedView view_;

    RefitPlan plan_;
    PinnedArray<vec3> staged_positions_m_;
    PinnedArray<vec3> staged_normals_;
    PinnedArray<WideNode> staged_upper_;
    PinnedArray<std::uint32_t> staged_roots_;
    DeviceArray<WideNode> upper_;
    DeviceArray<std::uint32_t> roots_;
    DeviceArray<Box> boxes_;
};

}  // namespace foverig::cuda
