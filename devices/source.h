#pragma once
// The sample seam: what a driver makes of a transport.
#include <concepts>
#include <cstdint>
#include <variant>

#include "devices/transport.h"

namespace foverig {

/// `next` gives a sample with its host time, or says why not.
template <class Sample>
using Next = std::variant<Sample, Timeout, EndOfStream, Fault>;

template <class S>
concept Source = requires(S& source, HostTime deadline) {
    { source.next(deadline) } -> std::same_as<Next<typename S::Sample>>;
};

/// Counts every source keeps; they end up in summary.json under devices.<name>.
struct SourceCounts {
    std::uint64_t samples = 0;
    std::uint64_t lost = 0;
    std::uint64_t rejected = 0;
    std::uint64_t reconnects = 0;
};

/// Requests of a source that came to nothing.
struct FailedRequests {
    std::uint64_t refused = 0;   ///< by the device, or not answered, or not as they should be
    std::uint64_t not_sent = 0;  ///< ErrorCode::not_asked

    void count(const Error& error) { ++(error.code == ErrorCode::not_asked ? not_sent : refused); }
};

}  // namespace foverig
