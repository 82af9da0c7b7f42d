#pragma once
#include <algorithm>
#include <thread>
#include <vector>

namespace foverig::gpu {

/// body(begin, end) over [0, n) in equal parts, one a core. For host work around the GPU; there is
/// no TBB on machines that this program is for.
template <class Body>
void in_threads(std::size_t n, const Body& body) {
    const std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::jthread> running;
    for (std::size_t i = 0; i < threads; ++i)
        running.emplace_back([&, i] { body(n * i / threads, n * (i + 1) / threads); });
}

}  // namespace foverig::gpu
