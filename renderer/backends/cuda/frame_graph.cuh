#pragma once
#include <memory>

#include "renderer/backends/cuda/check.cuh"

namespace foverig::cuda {

/// What a stream is given between begin and launch, sent to the device in one piece. The graph of
/// the frame before is updated where it has the same shape, and made anew where not.
class FrameGraph {
  public:
    void begin(cudaStream_t stream) {
        check(cudaStreamBeginCapture(stream, cudaStreamCaptureModeThreadLocal),
              "cudaStreamBeginCapture");
    }

    void launch(cudaStream_t stream) {
        cudaGraph_t captured = nullptr;
        check(cudaStreamEndCapture(stream, &captured), "cudaStreamEndCapture");
        const std::unique_ptr<CUgraph_st, Destroy> graph(captured);
        cudaGraphExecUpdateResultInfo info{};
        if (exec_ != nullptr && cudaGraphExecUpdate(exec_.get(), captured, &info) != cudaSuccess) {
            cudaGetLastError();  // another shape is no failure
            exec_.reset();
        }
        if (exec_ == nullptr) {
            cudaGraphExec_t exec = nullptr;
            check(cudaGraphInstantiate(&exec, captured, 0), "cudaGraphInstantiate");
            exec_.reset(exec);
            ++made_;
        }
        check(cudaGraphLaunch(exec_.get(), stream), "cudaGraphLaunch");
    }

    /// Ends a capture that failed half way; the failure itself is the caller's.
    static void abandon(cudaStream_t stream) {
        cudaGraph_t captured = nullptr;
        cudaStreamEndCapture(stream, &captured);
        if (captured != nullptr) cudaGraphDestroy(captured);
        cudaGetLastError();
    }

    int made() const { return made_; }  ///< graphs since the start: 1 if none had to be made anew

  private:
    struct Destroy {
        void operator()(cudaGraph_t graph) const { cudaGraphDestroy(graph); }
        void operator()(cudaGraphExec_t exec) const { cudaGraphExecDestroy(exec); }
    };
    std::unique_ptr<CUgraphExec_st, Destroy> exec_;
    int made_ = 0;
};

}  // namespace foverig::cuda
