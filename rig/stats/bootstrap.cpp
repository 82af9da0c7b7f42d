#include "rig/stats/bootstrap.h"

#include <algorithm>
#include <cmath>

#include "rig/stats/effective_count.h"
#include "rig/stats/quantile.h"
#include "simulators/motion/random.h"

namespace foverig::stats {

std::size_t block_length(std::span<const double> series) {
    if (series.empty()) return 1;
    const auto n = static_cast<double>(series.size());
    const double length = std::max(std::cbrt(n), n / effective_count(series));
    return static_cast<std::size_t>(std::ceil(length - 1e-9));
}

std::vector<double> block_bootstrap(std::span<const double> series, const Statistic& statistic,
                                    const BootstrapSettings& settings) {
    const std::size_t wanted = settings.block > 0 ? settings.block : block_length(series);
    const std::size_t block = std::min(wanted, series.size());
    const std::size_t starts = series.size() - block + 1;
    std::vector<double> values;
    std::vector<double> resampled(series.size());
    for (int i = 0; i < settings.resamples; ++i) {
        const motion::Draws draws(settings.seed, static_cast<std::uint64_t>(i));
        for (std::size_t at = 0; at < resampled.size(); at += block) {
            const double place = draws.uniform(at) * static_cast<double>(starts);
            const std::size_t start = std::min(static_cast<std::size_t>(place), starts - 1);
            const std::size_t count = std::min(block, resampled.size() - at);
            std::copy_n(series.begin() + static_cast<std::ptrdiff_t>(start), count,
                        resampled.begin() + static_cast<std::ptrdiff_t>(at));
        }
        values.push_back(statistic(resampled));
    }
    std::sort(values.begin(), values.end());
    return values;
}

std::optional<Interval> bootstrap_interval(std::span<const double> series,
                                           const Statistic& statistic,
                                           const BootstrapSettings& settings) {
    const std::size_t block = settings.block > 0 ? settings.block : block_length(series);
    if (series.size() < kLeastBlocks * block) return std::nullopt;
    const auto values = block_bootstrap(series, statistic, settings);
    constexpr double kTail = (1.0 - kConfidence) / 2.0;
    return Interval{quantile(values, kTail), quantile(values, 1.0 - kTail)};
}

}  // namespace foverig::stats
