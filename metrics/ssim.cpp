#include "metrics/ssim.h"

#include <array>
#include <cmath>

#include "metrics/display_code.h"
#include "metrics/rows.h"

namespace foverig::metrics {
namespace {

constexpr int kWindow = 11;
constexpr float kC1 = 0.01F * 255.0F * 0.01F * 255.0F;
constexpr float kC2 = 0.03F * 255.0F * 0.03F * 255.0F;
// Products of codes are large beside their variance; around this the two are of one size.
constexpr float kMiddle = 127.5F;

std::array<float, kWindow> window() {
    std::array<double, kWindow> w{};
    double sum = 0.0;
    for (int i = 0; i < kWindow; ++i) {
        const double d = i - kWindow / 2;
        sum += w[static_cast<std::size_t>(i)] = std::exp(-d * d / (2.0 * 1.5 * 1.5));
    }
    std::array<float, kWindow> taps{};
    for (std::size_t i = 0; i < taps.size(); ++i) taps[i] = static_cast<float>(w[i] / sum);
    return taps;
}

/// Means under the window of a, b, ab, (a - b)^2; first down the columns, then along the row.
struct Moments {
    std::array<std::vector<float>, 4> of_column;

    explicit Moments(std::size_t width) {
        for (auto& m : of_column) m.resize(width);
    }

    void add_row(const float* a, const float* b, float weight) {
        auto& [m_a, m_b, m_ab, m_dd] = of_column;
        for (std::size_t x = 0; x < m_a.size(); ++x) {
            const float va = a[x] - kMiddle;
            const float vb = b[x] - kMiddle;
            m_a[x] += weight * va;
            m_b[x] += weight * vb;
            m_ab[x] += weight * (va * vb);
            m_dd[x] += weight * ((va - vb) * (va - vb));
        }
    }
};

/// The formula's denominators are its numerators and what a and b differ by, so that it is 1 to the
/// last bit where they do not.
float similarity(float a, float b, float ab, float dd) {
    const float means = 2.0F * ((a + kMiddle) * (b + kMiddle)) + kC1;
    const float variances = 2.0F * (ab - a * b) + kC2;
    const float difference = (a - b) * (a - b);
    return means / (means + difference) * (variances / (variances + (dd - difference)));
}

double sum_of_row(const Moments& moments, const std::array<float, kWindow>& taps) {
    const std::size_t count = moments.of_column[0].size() - (kWindow - 1);
    std::array<std::vector<float>, 4> means;
    for (std::size_t m = 0; m < means.size(); ++m) {
        means[m].resize(count);
        for (std::size_t k = 0; k < taps.size(); ++k)
            for (std::size_t x = 0; x < count; ++x)
                means[m][x] += taps[k] * moments.of_column[m][x + k];
    }
    double sum = 0.0;
    for (std::size_t x = 0; x < count; ++x)
        sum += double{similarity(means[0][x], means[1][x], means[2][x], means[3][x])};
    return sum;
}

}  // namespace

std::optional<double> ssim(const Image& a, const Image& b) {
    check_same_size(a, b);
    if (a.width_px < kWindow || a.height_px < kWindow) return std::nullopt;
    const Plane luma_a = luma_codes(a);
    const Plane luma_b = luma_codes(b);
    const auto taps = window();
    const int rows = a.height_px - (kWindow - 1);
    const double sum = sum_of_rows<double>(rows, [&](int y) {
        Moments moments(static_cast<std::size_t>(a.width_px));
        for (int k = 0; k < kWindow; ++k)
            moments.add_row(luma_a.row(y + k), luma_b.row(y + k),
                            taps[static_cast<std::size_t>(k)]);
        return sum_of_row(moments, taps);
    });
    return sum / (static_cast<double>(rows) * (a.width_px - (kWindow - 1)));
}

}  // namespace foverig::metrics
