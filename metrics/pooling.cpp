#include "metrics/pooling.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace foverig::metrics {
namespace {

/// Sums of the errors by size, so that only the one class that a quantile falls into is sorted.
class Classes {
  public:
    Classes(const std::vector<float>& errors, float largest)
        : errors_(errors), scale_(largest > 1.0e-30F ? 65535.0F / largest : 0.0F), sums_(65536) {
        for (const float e : errors) sums_[class_of(e)] += double{e};
        for (const double s : sums_) total_ += s;
    }

    double quantile(double q) const {
        if (!(total_ > 0.0)) return 0.0;
        double running = 0.0;
        std::size_t found = 0;
        while (found + 1 < sums_.size() && !(running + sums_[found] > q * total_))
            running += sums_[found++];
        std::vector<float> members;
        std::copy_if(errors_.begin(), errors_.end(), std::back_inserter(members),
                     [&](float e) { return class_of(e) == found; });
        std::sort(members.begin(), members.end());
        for (const float e : members)
            if ((running += double{e}) > q * total_) return double{e};
        return members.empty() ? 0.0 : double{members.back()};
    }

    double total() const { return total_; }

  private:
    std::size_t class_of(float e) const { return static_cast<std::size_t>(e * scale_); }

    const std::vector<float>& errors_;
    float scale_;
    std::vector<double> sums_;
    double total_ = 0.0;
};

}  // namespace

Pooled pool(const Plane& errors) {
    if (errors.values.empty()) return {};
    const auto [min, max] = std::minmax_element(errors.values.begin(), errors.values.end());
    const Classes classes(errors.values, *max);
    return {.mean = classes.total() / static_cast<double>(errors.values.size()),
            .weighted_q1 = classes.quantile(0.25),
            .weighted_median = classes.quantile(0.5),
            .weighted_q3 = classes.quantile(0.75),
            .min = double{*min},
            .max = double{*max}};
}

}  // namespace foverig::metrics
