#pragma once
#include <cstddef>

#include "renderer/hd.h"

namespace foverig {

/// How many elements a queue holds: at most `most`, and *count where a pass of the frame counts
/// them. `count` lies where the backend's kernels run, so that no frame waits to read it.
struct QueueSize {
    int most = 0;
    const int* count = nullptr;

    RIG_HD int get() const { return count != nullptr ? *count : most; }
};

/// Most queues of one frame whose length a pass finds out.
inline constexpr std::size_t kMostNumbers = 8;

}  // namespace foverig
