#include "simulators/gaze/simulated_gaze.h"

#include <algorithm>

namespace foverig {
namespace {

Error unplugged() {
    return {ErrorCode::closed, "the simulated gaze tracker is unplugged (faults.gaze.unplug_at)"};
}

}  // namespace

SimulatedGaze::SimulatedGaze(Clock& clock, const motion::EyeMotion& eyes, const Settings& settings)
    : clock_(clock), eyes_(eyes), settings_(settings) {
    const HostTime now = clock.now();
    if (settings.faults.unplug_for > 0.0) {
        const HostTime from = now + from_seconds(settings.faults.unplug_at);
        outages_.push_back({from, from + from_seconds(settings.faults.unplug_for)});
    }
    plug_in(now);
}

void SimulatedGaze::plug_in(HostTime now) {
    firmware_.emplace(GazeFirmware::Settings{
        .eyes = &eyes_, .faults = settings_.faults, .seed = settings_.seed, .plugged_in = now});
}

void SimulatedGaze::cut_wire(HostTime at) {
    std::erase_if(wire_, [at](const Packet& packet) { return packet.arrival > at; });
}

void SimulatedGaze::advance(HostTime until) {
    if (firmware_) firmware_->advance(std::min(until, unplugged_at()), wire_);
    if (until >= unplugged_at()) {
        cut_wire(unplugged_at());
        firmware_.reset();
        plugged_again_at_ = outages_.front().to;
        outages_.pop_front();
        fault_due_ = true;
    }
    if (until >= plugged_again_at_ && !fault_due_) {
        plug_in(plugged_again_at_);
        plugged_again_at_ = HostTime::max();
    }
}

/// Of one that reaches into the next, both are one.
void SimulatedGaze::unplug_now(HostTime now, Nanoseconds duration) {
    Outage outage{now, now + duration};
    while (unplugged_at() <= outage.to) {
        outage.to = std::max(outage.to, outages_.front().to);
        outages_.pop_front();
    }
    outages_.push_front(outage);
}

NextPacket SimulatedGaze::next(HostTime deadline) {
    while (true) {
        const HostTime now = std::min(clock_.now(), deadline);
        advance(now);
        if (!wire_.empty() && wire_.front().arrival <= now) {
            Packet packet = std::move(wire_.front());
            wire_.pop_front();
            return packet;
        }
        if (!firmware_) {
            fault_due_ = false;
            return Fault{unplugged()};
        }
        if (now >= deadline) return Timeout{};
        HostTime event = std::min({deadline, firmware_->next_event(), unplugged_at()});
        if (!wire_.empty()) event = std::min(event, wire_.front().arrival);
        clock_.sleep_until(event);
    }
}

Status SimulatedGaze::control_set(std::uint8_t request, std::uint16_t value,
                                  std::span<const std::byte> data) {
    const HostTime now = clock_.now();
    advance(now);
    if (!firmware_) return unplugged();
    if (request == gaze::request::stop) {
        // What is still in flight is thrown away: no frame of a session comes after its STOP.
        cut_wire(now);
    }
    if (request == gaze::request::reset && value == gaze::kResetKey) {
        wire_.clear();
        plug_in(now);
        return Done{};
    }
    if (request == gaze::request::sim_fault) {
        const auto fault = gaze::SimFault::decode(data);
        if (fault && fault->kind == gaze::FaultKind::unplug) {
            unplug_now(now, std::chrono::milliseconds(fault->duration_ms));
            return Done{};
        }
    }
    return firmware_->set(request, value, data, now);
}

Result<std::vector<std::byte>> SimulatedGaze::control_get(std::uint8_t request, std::uint16_t value,
                                                          std::size_t size) {
    advance(clock_.now());
    if (!firmware_) return unplugged();
    auto answer = firmware_->get(request, value, clock_.now());
    if (answer && answer->size() != size) {
        return Error{ErrorCode::unsupported, "the simulated gaze tracker stalls: wrong length"};
    }
    return answer;
}

}  // namespace foverig
