#pragma once
#include <cstdint>
#include <optional>

#include "rig/records/frame_record.h"

namespace foverig {

/// Samples over the time they were taken in; no value for fewer than two.
inline std::optional<double> sample_rate_hz(std::uint64_t samples,
                                            const std::optional<HostTime>& first,
                                            const std::optional<SampleInstants>& newest) {
    if (samples < 2 || !first || !newest || newest->taken <= *first) return std::nullopt;
    return static_cast<double>(samples - 1) / to_seconds(newest->taken - *first);
}

}  // namespace foverig
