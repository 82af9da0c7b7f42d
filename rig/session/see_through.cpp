#include "rig/session/see_through.h"

#include "rig/session/device_rate.h"
#include "rig/session/see_through_lens.h"

namespace foverig {

void SeeThrough::read_until(HostTime deadline) {
    const bool changed = camera_.read_until(deadline);
    if (!camera_.newest()) instants_.reset();
    if (!changed) return;
    const HostTime exposed = camera_.newest()->stamp - from_seconds(1e-3 * settings_.latency_ms);
    instants_ = {exposed, camera_.newest()->arrival};
    shown_ = false;
    if (first_) return;
    first_ = exposed;
    before_first_ = camera_.counts().samples - 1;
}

std::optional<BehindPicture> SeeThrough::picture(const HeadTracker& head) {
    const camera::RgbImage* image = camera_.image();
    if (image == nullptr) return std::nullopt;
    const bool changed = !std::exchange(shown_, true);
    if (changed) {
        world_from_camera_ = head.predict(instants_->taken).world_from_head;
        lens_ = lens_of(settings_, image->width_px, image->height_px);
    }
    return BehindPicture{.width_px = image->width_px,
                         .height_px = image->height_px,
                         .srgb = image->bytes,
                         .changed = changed,
                         .lens = lens_,
                         .world_from_camera = world_from_camera_};
}

DeviceRecord SeeThrough::record() const {
    const SourceCounts counts = camera_.counts();
    return {.name = "see_through",
            .counts = counts,
            .rate_hz = sample_rate_hz(counts.samples - before_first_, first_, instants_)};
}

}  // namespace foverig
