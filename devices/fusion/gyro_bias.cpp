#include "devices/fusion/gyro_bias.h"

namespace foverig {
namespace {

double largest(const dvec3& v) {
    return glm::max(glm::max(std::abs(v.x), std::abs(v.y)), std::abs(v.z));
}

}  // namespace

void GyroBias::add(const dvec3& gyro_rad_s, double dt_s) {
    smooth_ = samples_ == 0 ? gyro_rad_s : glm::mix(smooth_, gyro_rad_s, config_.smoothing);
    const bool moves = largest(smooth_) >= config_.max_rate_rad_s ||
                       (samples_ > 0 && largest(smooth_ - mean_) >= config_.max_deviation_rad_s);
    if (moves) {
        if (still_s_ > config_.partial_s) adopt();
        restart();
        return;
    }
    ++samples_;
    mean_ += (gyro_rad_s - mean_) / static_cast<double>(samples_);
    still_s_ += dt_s;
    if (still_s_ >= config_.full_s) {
        adopt();
        restart();
    }
}

void GyroBias::adopt() {
    offset_rad_s_ = mean_;
    known_ = true;
}

void GyroBias::restart() {
    samples_ = 0;
    mean_ = dvec3(0);
    still_s_ = 0;
}

}  // namespace foverig
