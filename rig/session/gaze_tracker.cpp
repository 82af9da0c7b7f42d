#include "rig/session/gaze_tracker.h"

#include "rig/session/device_rate.h"
#include "rig/session/open_device.h"

namespace foverig {

GazeTracker::GazeTracker(Transport& transport, const Clock& clock,
                         std::function<void(const GazeSample&)> on_sample,
                         const gaze::GazeSourceConfig& config)
    : source_(opened("gaze", gaze::GazeSource::open(transport, clock, config))),
      on_sample_(std::move(on_sample)) {}

void GazeTracker::read_until(HostTime deadline) {
    while (true) {
        const auto next = source_.next(deadline);
        const auto* sample = std::get_if<GazeSample>(&next);
        if (sample == nullptr) return;
        if (on_sample_) on_sample_(*sample);
        filter_.add(*sample);
        if (!first_) first_ = sample->host_time;
        newest_any_ = {sample->host_time, sample->arrival};
        const bool seen =
            sample->left.ray.valid || sample->right.ray.valid || sample->combined.valid;
        if (seen) newest_ = newest_any_;
    }
}

DeviceRecord GazeTracker::record() const {
    return {
        .name = "gaze",
        .counts = source_.counts(),
        .rate_hz = sample_rate_hz(source_.counts().samples, first_, newest_any_),
        .troubles = by_key(GazeTroubles{.missed_exposures = source_.missed_exposures(),
                                        .dropped_by_device = source_.dropped_by_device(),
                                        .control_failures = source_.failed_requests().refused,
                                        .requests_not_sent = source_.failed_requests().not_sent})};
}

}  // namespace foverig
