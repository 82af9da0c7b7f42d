#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "rig/stats/interval.h"

namespace foverig::stats {

using Statistic = std::function<double(std::span<const double>)>;

struct BootstrapSettings {
    std::size_t block = 0;  ///< numbers that stay together; 0: block_length of the series
    int resamples = 2000;
    std::uint64_t seed = 1;
};

/// The cube root of n, or n over its effective count where dependence reaches further.
std::size_t block_length(std::span<const double> series);

/// The statistic of series made of blocks drawn from this one, any of its stretches as likely as
/// another (moving blocks, Kuensch 1989), sorted. The same for the same seed on every machine.
std::vector<double> block_bootstrap(std::span<const double> series, const Statistic& statistic,
                                    const BootstrapSettings& settings = {});

/// Percentile interval of that. No value where the series holds fewer than kLeastBlocks blocks.
inline constexpr std::size_t kLeastBlocks = 5;
std::optional<Interval> bootstrap_interval(std::span<const double> series,
                                           const Statistic& statistic,
                                           const BootstrapSettings& settings = {});

}  // namespace foverig::stats
