#pragma once
#include <cmath>
#include <cstddef>
#include <vector>

namespace foverig {

/// Pearson's statistic of counts against their expected values; bins that nothing should fall into
/// are left out.
inline double chi_square(const std::vector<double>& counts, const std::vector<double>& expected) {
    double sum = 0.0;
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (expected[i] > 0.0)
            sum += (counts[i] - expected[i]) * (counts[i] - expected[i]) / expected[i];
    return sum;
}

/// Point that chi-square with that many degrees of freedom passes with probability 1 - 1e-5 (Wilson
/// and Hilferty 1931).
inline double chi_square_bound(double freedom) {
    constexpr double kNormalQuantile = 4.2649;  // of 1 - 1e-5
    const double a = 2.0 / (9.0 * freedom);
    return freedom * std::pow(1.0 - a + kNormalQuantile * std::sqrt(a), 3.0);
}

}  // namespace foverig
