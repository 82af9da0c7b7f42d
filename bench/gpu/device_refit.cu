#include "bench/gpu/device_refit.h"

#include "bench/gpu/event_times.cuh"
#include "renderer/backends/cuda/device_scene.cuh"

namespace foverig::gpu {

using cuda::check;

namespace {

struct DestroyGraph {
    void operator()(cudaGraph_t graph) const { cudaGraphDestroy(graph); }
    void operator()(cudaGraphExec_t graph) const { cudaGraphExecDestroy(graph); }
};
using Graph = std::unique_ptr<CUgraph_st, DestroyGraph>;
using RunnableGraph = std::unique_ptr<CUgraphExec_st, DestroyGraph>;

template <class Work>
RunnableGraph captured(cudaStream_t stream, const Work& work) {
    check(cudaStreamBeginCapture(stream, cudaStreamCaptureModeThreadLocal),
          "cudaStreamBeginCapture");
    work();
    cudaGraph_t graph = nullptr;
    check(cudaStreamEndCapture(stream, &graph), "cudaStreamEndCapture");
    const Graph owned(graph);
    cudaGraphExec_t runnable = nullptr;
    check(cudaGraphInstantiate(&runnable, graph, 0), "cudaGraphInstantiate");
    return RunnableGraph(runnable);
}

}  // namespace

struct DeviceRefit::Parts {
    MemoryCount count;
    cuda::Stream stream;
    cuda::DeviceScene scene;
    RunnableGraph graph;

    Parts(const SceneView& view, const BvhView& bvh, const RefitPlan& plan)
        : stream(cuda::make_stream()), scene(count, view, bvh, stream.get(), plan) {}

    void wait() const {
        check(cudaStreamSynchronize(stream.get()), "cudaStreamSynchronize after a refit");
    }
    void launch_graph() {
        if (graph == nullptr)
            graph = captured(stream.get(), [&] {
                scene.upload(stream.get());
                scene.refit(stream.get());
            });
        check(cudaGraphLaunch(graph.get(), stream.get()), "cudaGraphLaunch");
    }
};

DeviceRefit::DeviceRefit(const SceneView& scene, const BvhView& bvh, const RefitPlan& plan)
    : parts_(std::make_unique<Parts>(scene, bvh, plan)) {}

DeviceRefit::~DeviceRefit() = default;

void DeviceRefit::move(const SceneView& posed) {
    parts_->scene.move(posed, parts_->stream.get());
    parts_->wait();
}

void DeviceRefit::move_by_graph(const SceneView& posed) {
    parts_->scene.stage(posed);
    parts_->launch_graph();
    parts_->wait();
}

std::vector<WideNode> DeviceRefit::nodes() const {
    return parts_->scene.nodes(parts_->stream.get());
}

std::vector<PackedTriangle> DeviceRefit::packed_triangles() const {
    return parts_->scene.packed_triangles(parts_->stream.get());
}

DeviceRefit::Times DeviceRefit::times(int repetitions) {
    cudaStream_t const stream = parts_->stream.get();
    cuda::DeviceScene& scene = parts_->scene;
    return {event_times_ms(stream, repetitions, [&] { scene.upload(stream); }),
            event_times_ms(stream, repetitions, [&] { scene.refit(stream); }),
            event_times_ms(stream, repetitions, [&] { parts_->launch_graph(); })};
}

}  // namespace foverig::gpu
