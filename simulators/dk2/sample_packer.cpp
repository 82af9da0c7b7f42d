#include "simulators/dk2/sample_packer.h"

#include <cmath>

namespace foverig {
namespace {

std::int32_t rounded(double v) {
    return static_cast<std::int32_t>(std::lround(v));
}
std::int32_t narrowed(std::int64_t v) {
    return static_cast<std::int32_t>(v);
}

}  // namespace

void SamplePacker::fold(const dk2::InertialSlot& s) {
    older_.accel[0] += s.accel.x;
    older_.accel[1] += s.accel.y;
    older_.accel[2] += s.accel.z;
    older_.gyro[0] += s.gyro.x;
    older_.gyro[1] += s.gyro.y;
    older_.gyro[2] += s.gyro.z;
}

void SamplePacker::add(const dk2::InertialSlot& sample, std::uint16_t count,
                       std::uint32_t stamp_us) {
    if (pending_ == dk2::kMaxNumSamples) {
        older_ = Sum{};
        pending_ = 1;
        first_count_ = static_cast<std::uint16_t>(count - 1);
    }
    if (pending_ == 0) {
        first_count_ = count;
    } else {
        fold(newest_);
    }
    newest_ = sample;
    stamp_us_ = stamp_us;
    ++pending_;
}

SamplePacker::Packed SamplePacker::packed() const {
    Packed packed{.num_samples = static_cast<std::uint8_t>(pending_),
                  .sample_count = first_count_,
                  .newest_stamp_us = stamp_us_,
                  .slots = {}};
    if (pending_ < 2) {
        packed.slots[0] = newest_;
        return packed;
    }
    const int n = pending_ - 1;
    // The firmware divides accelerations as integers, towards zero, and rates as floats.
    packed.slots[0] = {.accel = {narrowed(older_.accel[0] / n), narrowed(older_.accel[1] / n),
                                 narrowed(older_.accel[2] / n)},
                       .gyro = {rounded(older_.gyro[0] / n), rounded(older_.gyro[1] / n),
                                rounded(older_.gyro[2] / n)}};
    packed.slots[1] = newest_;
    return packed;
}

}  // namespace foverig
