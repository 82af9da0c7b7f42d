#include "devices/camera/blobs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "devices/camera/detail/lit_regions.h"

namespace foverig::camera {
namespace {

constexpr int kSampledEach = 61;  // a prime: no pattern of columns is met
constexpr double kQuartileOfNormal = 0.6745;
constexpr int kMargin_px = 2;  // a spot's faint skirt lies outside the threshold
constexpr double kSkirtSigmas = 2.0;

bool touches_border(const detail::Region& r, const GreyView& image) {
    return r.left == 0 || r.top == 0 || r.right == image.width_px - 1 ||
           r.bottom == image.height_px - 1;
}

bool like_an_led(const detail::Region& r, const BlobConfig& config) {
    const int width = r.right - r.left + 1, height = r.bottom - r.top + 1;
    const double longer = std::max(width, height), shorter = std::min(width, height);
    return r.area_px >= config.least_area_px && r.area_px <= config.most_area_px &&
           longer <= config.most_elongation * shorter &&
           r.area_px >= config.least_fill * width * height;
}

/// Half the way to the nearest other region, so that no light of it is taken.
int margin_of(const detail::Region& r, std::span<const detail::Region> all) {
    int margin = kMargin_px;
    for (const detail::Region& other : all) {
        if (&other == &r) continue;
        const int across = std::max(other.left - r.right, r.left - other.right) - 1;
        const int down = std::max(other.top - r.bottom, r.top - other.bottom) - 1;
        margin = std::min(margin, std::max(0, std::max(across, down)) / 2);
    }
    return margin;
}

Blob measured(const detail::Region& r, int margin_px, const GreyView& image,
              const Background& dark) {
    const double floor = dark.level + kSkirtSigmas * dark.sigma;
    double sum = 0, sum_x = 0, sum_y = 0;
    const int top = std::max(0, r.top - margin_px);
    const int bottom = std::min(image.height_px - 1, r.bottom + margin_px);
    const int left = std::max(0, r.left - margin_px);
    const int right = std::min(image.width_px - 1, r.right + margin_px);
    for (int y = top; y <= bottom; ++y) {
        const std::uint8_t* row = image.row(y);
        for (int x = left; x <= right; ++x) {
            const double light = std::max(0.0, row[x] - floor);
            sum += light;
            sum_x += light * (x - left);
            sum_y += light * (y - top);
        }
    }
    return {.center_px = {left + sum_x / sum, top + sum_y / sum},
            .brightness = sum,
            .area_px = r.area_px,
            .peak = r.peak};
}

}  // namespace

Background background_of(const GreyView& image) {
    std::array<int, 256> histogram{};
    int samples = 0;
    int skip = 0;
    for (int y = 0; y < image.height_px; ++y) {
        const std::uint8_t* row = image.row(y);
        int x = skip;
        for (; x < image.width_px; x += kSampledEach, ++samples) ++histogram[row[x]];
        skip = x - image.width_px;
    }
    const auto level_at = [&](double share) {
        int seen = 0;
        for (int level = 0; level < 256; ++level) {
            const int here = histogram[static_cast<std::size_t>(level)];
            if (seen + here > share * samples) return level - 0.5 + (share * samples - seen) / here;
            seen += here;
        }
        return 255.0;
    };
    const double median = level_at(0.5), lower = level_at(0.25);
    return {.level = median, .sigma = std::max(0.3, (median - lower) / kQuartileOfNormal)};
}

std::vector<Blob> find_blobs(const GreyView& image, const BlobConfig& config) {
    const Background dark = background_of(image);
    const double threshold =
        dark.level + std::max(config.least_threshold, config.threshold_sigmas * dark.sigma);
    std::vector<Blob> blobs;
    if (threshold >= 255) return blobs;
    const auto regions = detail::lit_regions(image, static_cast<int>(threshold));
    for (const detail::Region& r : regions) {
        if (touches_border(r, image) || !like_an_led(r, config)) continue;
        blobs.push_back(measured(r, margin_of(r, regions), image, dark));
        if (blobs.size() > config.most_blobs) break;
    }
    return blobs;
}

}  // namespace foverig::camera
