#include "renderer/backends/cuda/device_scene.cuh"

namespace foverig::cuda {

DeviceScene::DeviceScene(MemoryCount& count, const SceneView& scene, const BvhView& bvh,
                         cudaStream_t stream, const RefitPlan& plan)
    : plan_(plan),
      staged_positions_m_(count, moving_vertices(plan)),
      staged_normals_(count, moving_vertices(plan)),
      staged_upper_(count, plan.upper.capacity()),
      staged_roots_(count, plan.upper.capacity()),
      upper_(count, plan.upper.capacity()),
      roots_(count, plan.upper.capacity()),
      boxes_(count, plan.node_count()) {
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
    check(cudaStreamSynchronize(stream), "cudaStreamSynchronize after the scene's upload");
}

void DeviceScene::stage(const SceneView& posed) {
    pack_moved(plan_, posed,
               {staged_positions_m_.view(), staged_normals_.view(), staged_upper_.view(),
                staged_roots_.view()});
}

void DeviceScene::upload(cudaStream_t stream) {
    const auto copy = [&]<class T>(T* to, const T* from, std::size_t size) {
        check(cudaMemcpyAsync(to, from, size * sizeof(T), cudaMemcpyHostToDevice, stream),
              "cudaMemcpyAsync of what has moved");
    };
    if (!moves()) return;
    for_each_run(plan_, [&](const VertexRun& run, std::size_t at) {
        copy(positions_m_.data() + run.first, staged_positions_m_.data() + at, run.count);
        copy(normals_.data() + run.first, staged_normals_.data() + at, run.count);
    });
    copy(upper_.data(), staged_upper_.data(), upper_.size());
    copy(roots_.data(), staged_roots_.data(), roots_.size());
}

void DeviceScene::refit(cudaStream_t stream) {
    const RefitArrays arrays{
        view_.scene.positions_m, view_.scene.triangles, nodes_.view(), packed_triangles_.view(),
        boxes_.view(),           upper_.view(),         roots_.view()};
    refit_passes(plan_, arrays, [&](const char* name, int n, const auto& kernel) {
        if (n == 0) return;
        run<<<(n + kThreads - 1) / kThreads, kThreads, 0, stream>>>(kernel, QueueSize{n});
        check(cudaGetLastError(), name);
    });
}

void DeviceScene::move(const SceneView& posed, cudaStream_t stream) {
    stage(posed);
    upload(stream);
    refit(stream);
}

}  // namespace foverig::cuda
