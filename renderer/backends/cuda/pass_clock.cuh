#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "renderer/backends/cuda/handles.cuh"

namespace foverig::cuda {

/// Times of passes by events in the stream. Events are kept from frame to frame.
class PassClock {
  public:
    struct Pass {
        const char* name;
        int counter;  ///< where the pass counts its rays; < 0: it has none
        std::int64_t ns;
    };

    /// From now on the stream is captured, or not: an event of a graph is recorded another way.
    void set_captured(bool captured) {
        flags_ = captured ? cudaEventRecordExternal : cudaEventRecordDefault;
    }
    void begin(const char* name, int counter, cudaStream_t stream) {
        if (used_ == events_.size()) events_.push_back({make_event(), make_event()});
        names_.push_back({name, counter, 0});
        check(cudaEventRecordWithFlags(events_[used_].begin.get(), stream, flags_), name);
    }
    void end(cudaStream_t stream) {
        check(cudaEventRecordWithFlags(events_[used_].end.get(), stream, flags_),
              names_.back().name);
        ++used_;
    }
    /// Forgets passes that were begun in a frame that failed.
    void abandon() {
        names_.clear();
        used_ = 0;
        flags_ = cudaEventRecordDefault;
    }
    /// Passes since the last call, in order. The stream must have been waited for.
    std::vector<Pass> take() {
        for (std::size_t i = 0; i < names_.size(); ++i) {
            float ms = 0.0F;
            check(cudaEventElapsedTime(&ms, events_[i].begin.get(), events_[i].end.get()),
                  names_[i].name);
            names_[i].ns = static_cast<std::int64_t>(static_cast<double>(ms) * 1.0e6);
        }
        used_ = 0;
        return std::exchange(names_, {});
    }

  private:
    struct Pair {
        Event begin;
        Event end;
    };
    std::vector<Pair> events_;
    std::vector<Pass> names_;
    std::size_t used_ = 0;
    unsigned flags_ = cudaEventRecordDefault;
};

}  // namespace foverig::cuda
