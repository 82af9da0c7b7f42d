#include "metrics/flicker.h"

#include <algorithm>
#include <cmath>

#include "metrics/display_code.h"
#include "metrics/rows.h"

namespace foverig::metrics {

Flicker::Flicker(double frames_per_s) : filters_(frames_per_s) {}

void Flicker::see(const Image& reference, const Image& test) {
    check_same_size(reference, test);
    Plane error = luma_codes(test);
    const Plane luma = luma_codes(reference);
    std::transform(error.values.begin(), error.values.end(), luma.values.begin(),
                   error.values.begin(), [](float t, float r) { return t - r; });
    if (!errors_.empty() &&
        (errors_[0].width_px != error.width_px || errors_[0].height_px != error.height_px))
        check_same_size({errors_[0].width_px, errors_[0].height_px, {}}, reference);
    errors_.push_front(std::move(error));
    if (errors_.size() > filters_.transient.size()) errors_.pop_back();
}

void Flicker::add(const Image& reference, const Image& test) {
    see(reference, test);
    squares_ = Plane(reference.width_px, reference.height_px);
    const double squares = sum_of_rows<double>(reference.height_px, [&](int y) {
        std::vector<float> response(static_cast<std::size_t>(reference.width_px));
        for (std::size_t i = 0; i < filters_.transient.size(); ++i) {
            const float* row = errors_[std::min(i, errors_.size() - 1)].row(y);
            const auto tap = static_cast<float>(filters_.transient[i]);
            for (std::size_t x = 0; x < response.size(); ++x) response[x] += tap * row[x];
        }
        std::transform(response.begin(), response.end(), squares_.row(y),
                       [](float r) { return r * r; });
        double sum = 0.0;
        for (const float r : response) sum += double{r} * double{r};
        return sum;
    });
    newest_mean_square_ = squares / std::max(1.0, static_cast<double>(reference.pixels.size()));
    mean_squares_ += newest_mean_square_;
    ++frames_;
}

double Flicker::rms_codes() const {
    return frames_ > 1 ? std::sqrt(mean_squares_ / frames_) : 0.0;
}

double Flicker::newest_rms_codes() const {
    return std::sqrt(newest_mean_square_);
}

}  // namespace foverig::metrics
