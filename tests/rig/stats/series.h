#pragma once
// Series whose dependence is known.
#include <cmath>
#include <vector>

#include "simulators/motion/random.h"

namespace foverig::stats::test {

/// x(t) = phi x(t-1) + noise, standard normal margins: autocorrelation phi^lag.
inline std::vector<double> autoregressive(int n, double phi, std::uint64_t seed) {
    const motion::Draws draws(seed, 77);
    std::vector<double> series{draws.normal(0)};
    for (int i = 1; i < n; ++i) {
        const double noise = draws.normal(static_cast<std::uint64_t>(i));
        series.push_back(phi * series.back() + std::sqrt(1.0 - phi * phi) * noise);
    }
    return series;
}

}  // namespace foverig::stats::test
