#include "bench/image_error.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <bit>
#include <cmath>
#include <vector>

#include "renderer/kernels/camera_rays.h"

namespace foverig::bench {
namespace {

/// The renderer draws its fovea with a polynomial that is right to 0.001 deg.
constexpr double kMargin_deg = 0.01;

/// sRGB by the upper 19 bits of a float in [0, 1): exact for the halves that images are kept in.
const std::vector<float>& srgb_table() {
    static const std::vector<float> table = [] {
        std::vector<float> t(std::bit_cast<std::uint32_t>(1.0F) >> 13U);
        for (std::size_t i = 0; i < t.size(); ++i)
            t[i] = srgb_from_linear(std::bit_cast<float>(static_cast<std::uint32_t>(i) << 13U));
        return t;
    }();
    return table;
}

float quick_srgb(const float* table, float linear) {
    if (!(linear > 0.0F)) return 0.0F;
    return linear >= 1.0F ? 1.0F : table[std::bit_cast<std::uint32_t>(linear) >> 13U];
}

struct Sums {
    ImageError e;
    double inside_sum = 0.0;
    double outside_sum = 0.0;
    std::uint64_t outside_pixels = 0;

    void add(const Sums& o) {
        e.inside_pixels += o.e.inside_pixels;
        e.inside_equal += o.e.inside_equal;
        e.inside_max = std::max(e.inside_max, o.e.inside_max);
        e.not_finite += o.e.not_finite;
        inside_sum += o.inside_sum;
        outside_sum += o.outside_sum;
        outside_pixels += o.outside_pixels;
    }
};

}  // namespace

ImageError image_error(const Image& foveated, const Image& full, const EyeInput& eye,
                       double r0_deg) {
    const EyeRays rays(eye.view);
    const dvec3 gaze(glm::normalize(eye.view.world_from_eye * eye.gaze));
    const double cosine = std::cos(glm::radians(r0_deg - kMargin_deg));
    const float* const table = srgb_table().data();
    const auto add_row = [&](int y, Sums& sums) {
        for (int x = 0; x < full.width_px; ++x) {
            const vec3 a = foveated.at(x, y);
            const vec3 b = full.at(x, y);
            double difference = 0.0;
            double most = 0.0;
            for (int c = 0; c < 3; ++c) {
                if (!std::isfinite(a[c]) || !std::isfinite(b[c])) ++sums.e.not_finite;
                const double d =
                    std::abs(double{quick_srgb(table, a[c])} - double{quick_srgb(table, b[c])});
                difference += d;
                most = std::max(most, d);
            }
            const dvec3 direction(
                rays.direction(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F));
            if (glm::dot(direction, gaze) >= cosine * glm::length(direction)) {
                ++sums.e.inside_pixels;
                sums.e.inside_equal += a == b ? 1U : 0U;
                sums.e.inside_max = std::max(sums.e.inside_max, most);
                sums.inside_sum += difference;
            } else {
                ++sums.outside_pixels;
                sums.outside_sum += difference;
            }
        }
    };
    const Sums sums = tbb::parallel_reduce(
        tbb::blocked_range<int>(0, full.height_px, 64), Sums{},
        [&](const tbb::blocked_range<int>& rows, Sums partial) {
            for (int y = rows.begin(); y < rows.end(); ++y) add_row(y, partial);
            return partial;
        },
        [](Sums a, const Sums& b) {
            a.add(b);
            return a;
        });
    ImageError error = sums.e;
    const auto share = [](double sum, std::uint64_t pixels) {
        return pixels > 0 ? sum / (3.0 * static_cast<double>(pixels)) : 0.0;
    };
    error.outside_mean = share(sums.outside_sum, sums.outside_pixels);
    error.whole_mean =
        share(sums.inside_sum + sums.outside_sum, sums.outside_pixels + sums.e.inside_pixels);
    return error;
}

}  // namespace foverig::bench
