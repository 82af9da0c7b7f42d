#include "devices/camera/video_camera.h"

namespace foverig::camera {

bool VideoCamera::read_until(HostTime deadline) {
    const std::optional<Frame> before = newest_;
    while (true) {
        NextPacket got = transport_.next(deadline);
        if (auto* packet = std::get_if<Packet>(&got)) {
            take(std::move(*packet));
            continue;
        }
        if (std::holds_alternative<Fault>(got)) {
            was_gone_ = true;
            newest_.reset();
        }
        break;
    }
    return newest_ && (!before || before->arrival != newest_->arrival);
}

void VideoCamera::take(Packet packet) {
    const auto header = decode_any_header(packet.bytes);
    if (std::exchange(was_gone_, false)) count_.came_back();
    if (!count_.add(header)) return;
    newest_ = {.stamp = packet.arrival - std::chrono::microseconds(header->age_us),
               .arrival = packet.arrival};
    header_ = *header;
    packet_ = std::move(packet.bytes);
}

const RgbImage* VideoCamera::image() {
    if (!newest_) return nullptr;
    if (!packet_.empty()) {
        good_ = static_cast<bool>(to_rgb(header_, packet_, image_));
        broken_ += good_ ? 0 : 1;
        packet_ = {};
    }
    return good_ ? &image_ : nullptr;
}

SourceCounts VideoCamera::counts() const {
    SourceCounts counts = count_.counts();
    counts.samples -= broken_;
    counts.rejected += broken_;
    return counts;
}

}  // namespace foverig::camera
