#include "rig/stats/quantile.h"

#include <algorithm>
#include <cmath>

namespace foverig::stats {
namespace {

constexpr double kAlike = 1e-9;  // rounding of the logarithms

/// P(B = k) for B of n trials; by logarithms, so that it does not underflow for large n.
double binomial(std::uint64_t n, double share, std::uint64_t k) {
    const auto count = static_cast<double>(n);
    const auto hits = static_cast<double>(k);
    const double ways =
        std::lgamma(count + 1.0) - std::lgamma(hits + 1.0) - std::lgamma(count - hits + 1.0);
    return std::exp(ways + hits * std::log(share) + (count - hits) * std::log1p(-share));
}

}  // namespace

double quantile(std::span<const double> sorted, double share) {
    const double at = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const auto above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], at - static_cast<double>(below));
}

std::optional<Ranks> quantile_ranks(std::uint64_t n, double share, double confidence) {
    if (n < 2) return std::nullopt;
    // B numbers lie below the quantile; x_low..x_high hold it where low <= B < high.
    const auto likeliest = static_cast<std::uint64_t>(share * static_cast<double>(n + 1));
    std::uint64_t first = std::clamp<std::uint64_t>(likeliest, 1, n - 1);
    std::uint64_t last = first;
    double covered = binomial(n, share, first);
    while (covered < confidence) {
        const double before = first > 1 ? binomial(n, share, first - 1) : 0.0;
        const double after = last + 1 < n ? binomial(n, share, last + 1) : 0.0;
        if (before == 0.0 && after == 0.0) return std::nullopt;
        // Those alike likely are taken together, so that the median's ranks are symmetric.
        const bool take_before = before > after * (1.0 - kAlike);
        const bool take_after = after > before * (1.0 - kAlike);
        covered += (take_before ? before : 0.0) + (take_after ? after : 0.0);
        if (take_before) --first;
        if (take_after) ++last;
    }
    return Ranks{first, last + 1};
}

std::uint64_t least_count(double share, double confidence) {
    std::uint64_t n = 2;
    const auto missed = [&] {
        const auto count = static_cast<double>(n);
        return std::pow(share, count) + std::pow(1.0 - share, count);
    };
    while (missed() > 1.0 - confidence) ++n;
    return n;
}

}  // namespace foverig::stats
