#include "devices/gaze/data_quality.h"

#include <cmath>

#include "devices/gaze_angles.h"

namespace foverig::gaze {

void DataQualityMeter::add(const dvec3& direction) {
    if (follows_) {
        const double step_deg = angle_between_deg(directions_.back(), direction);
        squared_steps_deg2_ += step_deg * step_deg;
        ++steps_;
    }
    directions_.push_back(direction);
    follows_ = true;
}

DataQuality DataQualityMeter::against(const dvec3& target) const {
    DataQuality quality{.samples = directions_.size()};
    if (directions_.empty()) return quality;
    const auto count = static_cast<double>(directions_.size());
    dvec3 sum(0.0);
    double offsets_deg = 0.0;
    for (const dvec3& direction : directions_) {
        sum += direction;
        offsets_deg += angle_between_deg(direction, target);
    }
    quality.accuracy_deg = offsets_deg / count;
    if (steps_ == 0) return quality;
    quality.rms_s2s_deg = std::sqrt(squared_steps_deg2_ / static_cast<double>(steps_));
    double squares_deg2 = 0.0;
    for (const dvec3& direction : directions_) {
        const double angle_deg = angle_between_deg(direction, sum);
        squares_deg2 += angle_deg * angle_deg;
    }
    quality.sd_deg = std::sqrt(squares_deg2 / count);
    return quality;
}

DataQuality mean_of(const std::vector<DataQuality>& targets) {
    const auto mean = [&](double DataQuality::*figure) {
        double sum = 0.0;
        std::size_t known = 0;
        for (const DataQuality& target : targets) {
            if (std::isnan(target.*figure)) continue;
            sum += target.*figure;
            ++known;
        }
        return known == 0 ? DataQuality::kUnknown : sum / static_cast<double>(known);
    };
    DataQuality all{.accuracy_deg = mean(&DataQuality::accuracy_deg),
                    .rms_s2s_deg = mean(&DataQuality::rms_s2s_deg),
                    .sd_deg = mean(&DataQuality::sd_deg)};
    for (const DataQuality& target : targets) all.samples += target.samples;
    return all;
}

}  // namespace foverig::gaze
