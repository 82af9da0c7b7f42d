#include "rig/session/head_tracker.h"

#include "rig/session/device_rate.h"
#include "rig/session/open_device.h"

namespace foverig {

HeadTracker::HeadTracker(Transport& transport, HostTime now, const HeadFusionConfig& config,
                         std::function<void(const ImuSample&)> on_sample)
    : source_(opened("dk2", dk2::Dk2ImuSource::open(transport, now))),
      fusion_(config),
      on_sample_(std::move(on_sample)) {}

void HeadTracker::read_until(HostTime deadline) {
    while (true) {
        const auto next = source_.next(deadline);
        const auto* sample = std::get_if<ImuSample>(&next);
        if (sample == nullptr) return;
        if (on_sample_) on_sample_(*sample);
        fusion_.add(*sample);
        if (!first_) first_ = sample->host_time;
        newest_ = {sample->host_time, sample->arrival};
    }
}

DeviceRecord HeadTracker::record() const {
    return {"dk2", source_.counts(), sample_rate_hz(source_.counts().samples, first_, newest_)};
}

}  // namespace foverig
