#include "rig/stats/student_t.h"

#include <cmath>
#include <numbers>

#include "rig/stats/centre.h"

namespace foverig::stats {

double student_t_within(double t, int freedom) {
    const double angle = std::atan(t / std::sqrt(static_cast<double>(freedom)));
    const double cosine2 = std::cos(angle) * std::cos(angle);
    const bool odd = freedom % 2 == 1;
    double term = odd ? std::cos(angle) : 1.0;
    double sum = freedom == 1 ? 0.0 : term;
    for (int k = odd ? 3 : 2; k < freedom; k += 2) {
        term *= cosine2 * (k - 1) / k;
        sum += term;
    }
    const double series = std::sin(angle) * sum;
    return odd ? (angle + series) * 2.0 / std::numbers::pi : series;
}

double student_t_bound(int freedom) {
    double low = 0.0;
    double high = 20.0;  // 12.7 of one degree is the largest
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (student_t_within(middle, freedom) < kConfidence ? low : high) = middle;
    }
    return high;
}

std::optional<Interval> mean_interval(std::span<const double> numbers) {
    if (numbers.size() < 2) return std::nullopt;
    const double mean = mean_of(numbers);
    double squares = 0.0;
    for (const double number : numbers) squares += (number - mean) * (number - mean);
    const auto n = static_cast<double>(numbers.size());
    const double error = std::sqrt(squares / (n - 1.0) / n);
    const double half = student_t_bound(static_cast<int>(numbers.size()) - 1) * error;
    return Interval{mean - half, mean + half};
}

}  // namespace foverig::stats
