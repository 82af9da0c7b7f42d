#include "devices/camera/exposure_pairing.h"

namespace foverig::camera {
namespace {

constexpr std::size_t kKept = 256;  // 4 s: more than the frames that wait for a slow frame of a run
// The clock map may be late by this much; what it gives is not much later than the truth.
constexpr Nanoseconds kEarliest{1'000'000};
constexpr Nanoseconds kLatest{12'000'000};  // between this flash and the next one's frame

}  // namespace

void ExposurePairing::add(const dk2::LedExposure& exposure) {
    if (counting_) number_ += static_cast<std::uint16_t>(exposure.count - last_count_);
    counting_ = true;
    last_count_ = exposure.count;
    exposures_.push_back({.number = number_,
                          .pattern = exposure.pattern,
                          .middle = exposure.start + half_flash_,
                          .middle_device = exposure.start_device + half_flash_});
    if (exposures_.size() > kKept) exposures_.pop_front();
}

std::optional<PairedExposure> ExposurePairing::of(HostTime frame_stamp) {
    std::optional<PairedExposure> found;
    while (!exposures_.empty() &&
           exposures_.front().middle - half_flash_ <= frame_stamp + kEarliest) {
        found = exposures_.front();
        exposures_.pop_front();
    }
    if (found && frame_stamp - found->middle > kLatest) return std::nullopt;
    return found;
}

}  // namespace foverig::camera
