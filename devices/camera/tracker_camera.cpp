#include "devices/camera/tracker_camera.h"

namespace foverig::camera {
namespace {

constexpr Nanoseconds kSetUpPause{250'000'000};  // between two tries with a camera that came back

}  // namespace

Result<TrackerCamera> TrackerCamera::open(Transport& transport, Sync sync) {
    TrackerCamera camera(transport, sync);
    if (auto status = camera.set_up(); !status) return status.error();
    return camera;
}

Status TrackerCamera::set_up() {
    const Status status = set_up_bridge();
    as_it_is_.reset();
    if (status) return Done{};
    if (status.error().code != ErrorCode::unsupported) return status.error();
    as_it_is_ = status.error();
    return Done{};
}

Status TrackerCamera::set_up_bridge() {
    Esp570 bridge(*transport_);
    // Nobody knows what for: a camera that will not be greeted is set up all the same.
    (void)bridge.greet();
    if (auto status = set_up_sensor(bridge, sync_); !status) return status;
    const auto block = bridge.read_eeprom(eeprom::kLensBlock, kLensBlockSize);
    if (!block) return block.error();
    // A worn-out memory is no reason not to track: the design's lens is near enough to begin with.
    if (const auto lens = decode_lens_block(*block)) {
        lens_ = *lens;
        calibrated_ = true;
    }
    return Done{};
}

/// A camera that comes back runs freely until it is told to follow the headset.
void TrackerCamera::set_up_again(HostTime now) {
    if (!was_gone_ || now < next_set_up_) return;
    was_gone_ = !set_up();
    if (was_gone_) {
        next_set_up_ = now + kSetUpPause;
        return;
    }
    count_.came_back();
}

Next<CameraFrame> TrackerCamera::next(HostTime deadline) {
    while (true) {
        NextPacket got = transport_->next(deadline);
        if (auto* packet = std::get_if<Packet>(&got)) {
            set_up_again(packet->arrival);
            if (auto frame = take(std::move(*packet))) return std::move(*frame);
        } else if (auto* fault = std::get_if<Fault>(&got)) {
            was_gone_ = true;
            return std::move(*fault);
        } else if (std::holds_alternative<Timeout>(got)) {
            return Timeout{};
        } else {
            return EndOfStream{};
        }
    }
}

std::optional<CameraFrame> TrackerCamera::take(Packet packet) {
    const auto header = decode_header(packet.bytes);
    if (!count_.add(header)) return std::nullopt;
    return CameraFrame{.stamp = packet.arrival - std::chrono::microseconds(header->age_us),
                       .arrival = packet.arrival,
                       .header = *header,
                       .packet = std::move(packet.bytes)};
}

}  // namespace foverig::camera
