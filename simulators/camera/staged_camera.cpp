#include "simulators/camera/staged_camera.h"

#include "devices/dk2/feature_reports.h"

namespace foverig {
namespace {

constexpr Nanoseconds kTellEvery{3'000'000'000};  // it sleeps after ten seconds

}  // namespace

StagedCamera::StagedCamera(Transport& camera, Transport& headset, const Clock& clock)
    : camera_(camera), headset_(headset), clock_(clock), tell_again_(clock.now()) {}

NextPacket StagedCamera::next(HostTime deadline) {
    const HostTime now = clock_.now();
    light(now);
    while (true) {  // nobody reads its reports
        const NextPacket report = headset_.next(now);
        dark_ |= std::holds_alternative<Fault>(report);
        if (!std::holds_alternative<Packet>(report)) break;
    }
    return camera_.next(deadline);
}

/// One that was unplugged has forgotten that it should blink.
void StagedCamera::light(HostTime now) {
    if (now < tell_again_) return;
    tell_again_ = now + kTellEvery;
    if (dark_) {
        const dk2::TrackingReport blink{
            .enable = true, .exposure_us = 350, .frame_interval_us = 16666};
        dark_ = !headset_.control_set(dk2::TrackingReport::kId, 0, blink.encode());
    }
    (void)headset_.control_set(dk2::KeepAliveMuxReport::kId, 0, dk2::KeepAliveMuxReport{}.encode());
}

}  // namespace foverig
