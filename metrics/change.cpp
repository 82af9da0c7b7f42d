#include "metrics/change.h"

#include <cmath>

#include "metrics/display_code.h"
#include "metrics/rows.h"

namespace foverig::metrics {
namespace {

struct Sums {
    double reference = 0.0;
    double test = 0.0;
    double magnitude = 0.0;
    double square = 0.0;

    Sums& operator+=(const Sums& o) {
        reference += o.reference;
        test += o.test;
        magnitude += o.magnitude;
        square += o.square;
        return *this;
    }
};

Image codes_of(const Image& image) {
    Image codes = image;
    for_rows(codes.height_px, [&](int y) {
        float* row = &codes.at(0, y).x;
        for (int i = 0; i < 3 * codes.width_px; ++i) row[i] = display_code(row[i]);
    });
    return codes;
}

}  // namespace

void ChangeOverTime::add(const Image& reference, const Image& test) {
    check_same_size(reference, test);
    Image now_r = codes_of(reference);
    Image now_t = codes_of(test);
    if (begun_) {
        check_same_size(reference_, now_r);
        const Sums sums = sum_of_rows<Sums>(now_r.height_px, [&](int y) {
            const float* r0 = &reference_.at(0, y).x;
            const float* t0 = &test_.at(0, y).x;
            const float* r1 = &now_r.at(0, y).x;
            const float* t1 = &now_t.at(0, y).x;
            Sums s;
            for (int i = 0; i < 3 * now_r.width_px; ++i) {
                const double r = double{r1[i]} - double{r0[i]};
                const double t = double{t1[i]} - double{t0[i]};
                s.reference += std::abs(r);
                s.test += std::abs(t);
                s.magnitude += std::abs(t - r);
                s.square += (t - r) * (t - r);
            }
            return s;
        });
        const double n = 3.0 * static_cast<double>(now_r.pixels.size());
        newest_ = {1, sums.reference / n, sums.test / n, sums.magnitude / n, sums.square / n};
        ++sum_.pairs;
        sum_.reference += newest_.reference;
        sum_.test += newest_.test;
        sum_.mae += newest_.mae;
        sum_.mse += newest_.mse;
    }
    take(std::move(now_r), std::move(now_t));
}

void ChangeOverTime::see(const Image& reference, const Image& test) {
    check_same_size(reference, test);
    if (begun_) check_same_size(reference_, reference);
    take(codes_of(reference), codes_of(test));
}

void ChangeOverTime::take(Image reference_codes, Image test_codes) {
    reference_ = std::move(reference_codes);
    test_ = std::move(test_codes);
    begun_ = true;
}

Change ChangeOverTime::change() const {
    const double n = std::max(1, sum_.pairs);
    return {sum_.pairs, sum_.reference / n, sum_.test / n, sum_.mae / n, sum_.mse / n};
}

}  // namespace foverig::metrics
