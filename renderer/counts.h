#pragma once
#include <cstdint>

namespace foverig {

/// Rays of one frame, by what they ask.
struct RayCounts {
    std::uint64_t primary = 0;
    std::uint64_t shadow = 0;
    std::uint64_t ao = 0;
    std::uint64_t reflection = 0;
    std::uint64_t probe = 0;
    std::uint64_t vpl = 0;
    std::uint64_t total() const { return primary + shadow + ao + reflection + probe + vpl; }
};

/// What kernels met that should not be: a report with a NaN in it is not valid.
struct NumericCounts {
    std::uint64_t nan = 0;
    std::uint64_t inf = 0;
    std::uint64_t clamped = 0;
};

}  // namespace foverig
