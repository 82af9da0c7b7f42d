#include "metrics/pixel_errors.h"

#include <cmath>
#include <limits>

#include "metrics/display_code.h"
#include "metrics/rows.h"

namespace foverig::metrics {
namespace {

struct Sums {
    double squares = 0.0;
    double magnitudes = 0.0;
    double largest = 0.0;

    Sums& operator+=(const Sums& o) {
        squares += o.squares;
        magnitudes += o.magnitudes;
        largest = std::max(largest, o.largest);
        return *this;
    }
};

/// `difference(a, b)` of two rows' channels, summed up.
template <class Difference>
Differences differences(const Image& a, const Image& b, const Difference& difference) {
    check_same_size(a, b);
    const Sums sums = sum_of_rows<Sums>(a.height_px, [&](int y) {
        std::vector<float> row(static_cast<std::size_t>(a.width_px) * 3);
        const float* in_a = &a.at(0, y).x;
        const float* in_b = &b.at(0, y).x;
        for (std::size_t i = 0; i < row.size(); ++i) row[i] = difference(in_a[i], in_b[i]);
        Sums s;
        for (const float d : row) {
            s.squares += double{d} * double{d};
            s.magnitudes += std::abs(double{d});
            s.largest = std::max(s.largest, std::abs(double{d}));
        }
        return s;
    });
    const double n = 3.0 * std::max(1.0, static_cast<double>(a.pixels.size()));
    return {sums.squares / n, sums.magnitudes / n, sums.largest};
}

struct RelativeSums {
    double square = 0.0;
    double magnitude = 0.0;
    double symmetric = 0.0;

    RelativeSums& operator+=(const RelativeSums& o) {
        square += o.square;
        magnitude += o.magnitude;
        symmetric += o.symmetric;
        return *this;
    }
};

}  // namespace

Differences code_differences(const Image& a, const Image& b) {
    return differences(a, b, [](float x, float y) { return display_code(x) - display_code(y); });
}

Differences linear_differences(const Image& a, const Image& b) {
    return differences(a, b, [](float x, float y) { return x - y; });
}

double psnr_db(double mse) {
    if (mse == 0.0) return std::numeric_limits<double>::infinity();
    return 10.0 * std::log10(255.0 * 255.0 / mse);
}

RelativeDifferences relative_differences(const Image& reference, const Image& test) {
    check_same_size(reference, test);
    const RelativeSums sums = sum_of_rows<RelativeSums>(reference.height_px, [&](int y) {
        const float* in_r = &reference.at(0, y).x;
        const float* in_t = &test.at(0, y).x;
        RelativeSums s;
        for (int i = 0; i < 3 * reference.width_px; ++i) {
            const double r = double{in_r[i]};
            const double t = double{in_t[i]};
            const double d = std::abs(t - r);
            s.square += d * d / (r * r + kRelativeFloor);
            s.magnitude += d / (std::abs(r) + kRelativeFloor);
            s.symmetric += 2.0 * d / (std::abs(r) + std::abs(t) + kRelativeFloor);
        }
        return s;
    });
    const double n = 3.0 * std::max(1.0, static_cast<double>(reference.pixels.size()));
    return {sums.square / n, sums.magnitude / n, sums.symmetric / n};
}

}  // namespace foverig::metrics
