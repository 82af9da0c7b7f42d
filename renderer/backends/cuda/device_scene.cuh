#pragma once
#include "renderer/backends/cuda/device_array.cuh"
#include "renderer/backends/cuda/queue_kernels.cuh"

namespace foverig::cuda {

/// Device copies of the arrays of a SceneView and a BvhView.
class DeviceScene {
  public:
    /// Has copied everything on return.
    DeviceScene(MemoryCount& count, const SceneView& scene, const BvhView& bvh,
                cudaStream_t stream);

    const TracedView& view() const { return view_; }

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
};

}  // namespace foverig::cuda
