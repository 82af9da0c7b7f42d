#pragma once
#include <cstdint>
#include <optional>
#include <string>

namespace foverig {

/// The machine a run is made on. What cannot be found out is absent.
struct HostInfo {
    std::optional<std::string> cpu;
    unsigned cores = 0;  ///< that this process may use
    std::optional<std::string> os;
};

HostInfo host_info();

/// Most memory this process has held so far.
std::uint64_t peak_rss_bytes();

}  // namespace foverig
