#include "metrics/regional_change.h"

#include <cmath>

#include "metrics/display_code.h"
#include "metrics/rows.h"

namespace foverig::metrics {
namespace {

vec3 codes_of(const vec3& linear) {
    return {display_code(linear.x), display_code(linear.y), display_code(linear.z)};
}

float mean_magnitude(const vec3& v) {
    return (std::abs(v.x) + std::abs(v.y) + std::abs(v.z)) * (1.0F / 3.0F);
}

/// Magnitudes of the changes from one frame to the next, means of the channels.
struct Changes {
    Plane reference, test, difference;

    Changes(const Image& reference_0, const Image& test_0, const Image& reference_1,
            const Image& test_1)
        : reference(reference_0.width_px, reference_0.height_px),
          test(reference),
          difference(reference) {
        for_rows(reference.height_px, [&](int y) {
            for (int x = 0; x < reference.width_px; ++x) {
                const vec3 r = codes_of(reference_1.at(x, y)) - codes_of(reference_0.at(x, y));
                const vec3 t = codes_of(test_1.at(x, y)) - codes_of(test_0.at(x, y));
                reference.row(y)[x] = mean_magnitude(r);
                test.row(y)[x] = mean_magnitude(t);
                difference.row(y)[x] = mean_magnitude(t - r);
            }
        });
    }
};

std::optional<RegionalChange::Region> mean_of(const RegionalChange::Region& sum,
                                              std::size_t frames) {
    if (frames == 0) return std::nullopt;
    const auto n = static_cast<double>(frames);
    return RegionalChange::Region{sum.reference / n, sum.test / n, sum.mae / n,
                                  std::sqrt(sum.flicker_rms / n)};
}

}  // namespace

void RegionalChangeOverTime::add(const Image& reference, const Image& test, const GazedView& view) {
    flicker_.add(reference, test);
    if (frames_++ > 0) {
        const Changes changes(reference_, test_, reference, test);
        const GazedError r = pool_by_gaze(changes.reference, view, fovea_deg_);
        const GazedError t = pool_by_gaze(changes.test, view, fovea_deg_);
        const GazedError d = pool_by_gaze(changes.difference, view, fovea_deg_);
        const GazedError f = pool_by_gaze(flicker_.squares(), view, fovea_deg_);
        const auto add_to = [&](Sums& sums, double GazedError::*region) {
            ++sums.frames;
            sums.sum.reference += r.*region;
            sums.sum.test += t.*region;
            sums.sum.mae += d.*region;
            sums.sum.flicker_rms += f.*region;
        };
        if (r.fovea_pixels > 0) add_to(fovea_, &GazedError::fovea);
        if (r.fovea_pixels < reference.pixels.size()) add_to(periphery_, &GazedError::periphery);
    }
    reference_ = reference;
    test_ = test;
}

RegionalChange RegionalChangeOverTime::change() const {
    return {mean_of(fovea_.sum, fovea_.frames), mean_of(periphery_.sum, periphery_.frames)};
}

}  // namespace foverig::metrics
