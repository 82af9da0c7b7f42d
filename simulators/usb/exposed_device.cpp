#include "simulators/usb/exposed_device.h"

#include <algorithm>

namespace foverig::usb {
namespace {

constexpr Nanoseconds kUsbFrame{1'000'000};

}  // namespace

Result<std::unique_ptr<ExposedDevice>> ExposedDevice::begin(LockedTransport& model, Clock& clock,
                                                            PlugIn plug_in) {
    auto face = plug_in();
    if (!face) return face.error();
    return std::unique_ptr<ExposedDevice>(
        new ExposedDevice(model, clock, std::move(plug_in), std::move(face).value()));
}

ExposedDevice::ExposedDevice(LockedTransport& model, Clock& clock, PlugIn plug_in,
                             std::unique_ptr<Face> face)
    : model_(model),
      clock_(clock),
      plug_in_(std::move(plug_in)),
      face_(std::move(face)),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

void ExposedDevice::run(const std::stop_token& stop) {
    HostTime frame = clock_.now();
    while (!stop.stop_requested() && pass_on(stop)) {
        frame = std::max(frame + kUsbFrame, clock_.now());
        clock_.sleep_until(frame);
    }
    unplug();
}

bool ExposedDevice::pass_on(const std::stop_token& stop) {
    if (face_ && !face_->connected()) return end();
    while (!stop.stop_requested()) {  // a model that is slower than its clock always has more
        NextPacket next = model_.next(clock_.now());
        if (auto* packet = std::get_if<Packet>(&next)) {
            if (!face_ && !plug_in_again()) return false;
            face_->send(std::move(packet->bytes).release());
            note_unheard();
            const std::lock_guard lock(mutex_);
            ++counts_.packets;
        } else if (std::holds_alternative<Timeout>(next)) {
            return face_ || plug_in_again();
        } else if (std::holds_alternative<Fault>(next)) {
            unplug();
            return true;
        } else {
            return end();
        }
    }
    return false;
}

bool ExposedDevice::plug_in_again() {
    auto face = plug_in_();
    if (!face) return end(face.error());
    face_ = std::move(face).value();
    const std::lock_guard lock(mutex_);
    ++counts_.plugged_in;
    return true;
}

void ExposedDevice::unplug() {
    if (!face_) return;
    note_unheard();
    unheard_before_ += face_->unheard();
    face_.reset();
}

void ExposedDevice::note_unheard() {
    const std::uint64_t unheard = unheard_before_ + face_->unheard();
    const std::lock_guard lock(mutex_);
    counts_.unheard = unheard;
}

bool ExposedDevice::end(std::optional<Error> error) {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    error_ = std::move(error);
    return false;
}

ExposedDevice::Counts ExposedDevice::counts() const {
    const std::lock_guard lock(mutex_);
    return counts_;
}
bool ExposedDevice::ended() const {
    const std::lock_guard lock(mutex_);
    return ended_;
}
std::optional<Error> ExposedDevice::error() const {
    const std::lock_guard lock(mutex_);
    return error_;
}

}  // namespace foverig::usb
