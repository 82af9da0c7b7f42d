#include "renderer/backends/cuda/device_scene.cuh"

namespace foverig::cuda {

DeviceScene::DeviceScene(MemoryCount& count, const SceneView& scene, const BvhView& bvh,
                         cudaStream_t stream) {
    const auto copy = [&]<class T>(DeviceArray<T>& array, View<const T> from) {
        array = DeviceArray<T>(count, from.size);
        if (!from.empty()) array.upload(from, stream);
        return std::as_const(array).view();
    };
    SceneView& s = view_.scene;
    s.positions_m = copy(positions_m_, scene.positions_m);
    s.normals = copy(normals_, scene.normals);
    s.texcoords = copy(texcoords_, scene.texcoords);
    s.triangles = copy(triangles_, scene.triangles);
    s.triangle_materials = copy(triangle_materials_, scene.triangle_materials);
    s.texel_density_log2 = copy(texel_density_log2_, scene.texel_density_log2);
    s.materials = copy(materials_, scene.materials);
    s.textures = copy(textures_, scene.textures);
    s.texels = copy(texels_, scene.texels);
    s.linear_texels = copy(linear_texels_, scene.linear_texels);
    s.mips = copy(mips_, scene.mips);
    s.point_lights = copy(point_lights_, scene.point_lights);
    s.area_lights = copy(area_lights_, scene.area_lights);
    s.ambient = scene.ambient;
    s.background = scene.background;
    view_.bvh.nodes = copy(nodes_, bvh.nodes);
    view_.bvh.triangles = copy(packed_triangles_, bvh.triangles);
    view_.bvh.bounds = bvh.bounds;
    check(cudaStreamSynchronize(stream), "cudaStreamSynchronize after the scene's upload");
}

}  // namespace foverig::cuda
