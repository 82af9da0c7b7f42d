#pragma once
// How the DK2's firmware folds samples into one input report (DEVICES.md 1.4).
#include <array>
#include <cstdint>

#include "devices/dk2/input_reports.h"

namespace foverig {

/// Samples since the last report that was queued.
class SamplePacker {
  public:
    struct Packed {
        std::uint8_t num_samples = 0;
        std::uint16_t sample_count = 0;  ///< of the first one
        std::uint32_t newest_stamp_us = 0;
        std::array<dk2::InertialSlot, 2> slots;  ///< 1: sample, zeros; 2: older, newer; more: mean
                                                 ///< of all but the newest, newest
    };

    /// The 255th drops the mean: the last two remain.
    void add(const dk2::InertialSlot& sample, std::uint16_t count, std::uint32_t stamp_us);
    int pending() const { return pending_; }
    /// What is pending, without taking it.
    Packed packed() const;
    void clear() { *this = SamplePacker(); }

  private:
    struct Sum {
        std::array<std::int64_t, 3> accel{};
        std::array<double, 3> gyro{};
    };
    void fold(const dk2::InertialSlot& sample);

    int pending_ = 0;
    std::uint16_t first_count_ = 0;
    std::uint32_t stamp_us_ = 0;
    dk2::InertialSlot newest_;
    Sum older_;  ///< of all pending but the newest
};

}  // namespace foverig
