#include "simulators/dk2/simulated_dk2.h"

#include <fmt/format.h>

#include <algorithm>

namespace foverig {
namespace {

Error unplugged() {
    return {ErrorCode::closed, "the simulated DK2 is unplugged (faults.dk2.unplug_at)"};
}

}  // namespace

SimulatedDk2::SimulatedDk2(Clock& clock, const motion::HeadMotion& head, const Settings& settings)
    : clock_(clock), head_(head), settings_(settings), wire_(settings.faults, settings.seed) {
    const HostTime now = clock.now();
    if (settings.faults.unplug_for > 0.0) {
        unplugged_at_ = now + from_seconds(settings.faults.unplug_at);
        plugged_again_at_ = unplugged_at_ + from_seconds(settings.faults.unplug_for);
    }
    plug_in(now);
}

void SimulatedDk2::plug_in(HostTime now) {
    firmware_ =
        std::make_unique<Dk2Firmware>(Dk2Firmware::Settings{.head = &head_,
                                                            .panel = settings_.panel,
                                                            .faults = settings_.faults,
                                                            .seed = settings_.seed,
                                                            .plugged_in = now,
                                                            .poll_phase = settings_.poll_phase});
}

void SimulatedDk2::run_firmware(HostTime until) {
    while (keep_alive_ && keep_alive_->due <= until) {
        firmware_->advance(keep_alive_->due, wire_);
        (void)firmware_->set(keep_alive_->report, keep_alive_->due);
        keep_alive_->due += keep_alive_->period;
    }
    firmware_->advance(until, wire_);
}

void SimulatedDk2::advance(HostTime until) {
    if (firmware_) run_firmware(std::min(until, unplugged_at_));
    if (until >= unplugged_at_) {
        firmware_.reset();
        unplugged_at_ = HostTime::max();
        fault_due_ = true;
    }
    if (until >= plugged_again_at_ && !fault_due_) {
        plug_in(plugged_again_at_);
        if (keep_alive_) keep_alive_->due = plugged_again_at_ + keep_alive_->period;
        plugged_again_at_ = HostTime::max();
        run_firmware(until);
    }
}

NextPacket SimulatedDk2::next(HostTime deadline) {
    while (true) {
        const HostTime now = std::min(clock_.now(), deadline);
        advance(now);
        if (auto packet = wire_.take(now)) return std::move(*packet);
        // What the host already holds still comes after the cable is out.
        const auto arrival = wire_.first_arrival();
        if (!firmware_ && !arrival) {
            fault_due_ = false;
            return Fault{unplugged()};
        }
        if (now >= deadline) return Timeout{};
        const HostTime event =
            firmware_ ? std::min(firmware_->next_event(), unplugged_at_) : HostTime::max();
        clock_.sleep_until(std::min({deadline, event, arrival.value_or(HostTime::max())}));
    }
}

std::optional<LedFlash> SimulatedDk2::flash_after(HostTime t) const {
    if (!firmware_) return std::nullopt;
    const auto flash = firmware_->flash_after(t);
    return flash && flash->start < unplugged_at_ ? flash : std::nullopt;
}

Status SimulatedDk2::control_set(std::uint8_t id, std::uint16_t, std::span<const std::byte> data) {
    advance(clock_.now());
    if (!firmware_) return unplugged();
    if (data.empty() || read_u8(data, 0) != id) {
        return Error{ErrorCode::invalid_data,
                     fmt::format("feature report {} does not start with its id", id)};
    }
    return firmware_->set(data, clock_.now());
}

void SimulatedDk2::keep_awake(std::uint8_t, std::span<const std::byte> data, Nanoseconds period) {
    if (period <= Nanoseconds{0}) return;
    keep_alive_ = KeepAlive{to_vector(data), period, clock_.now() + period};
}

Result<std::vector<std::byte>> SimulatedDk2::control_get(std::uint8_t id, std::uint16_t,
                                                         std::size_t size) {
    advance(clock_.now());
    if (!firmware_) return unplugged();
    auto bytes = firmware_->get(id);
    if (!bytes) return bytes;
    std::vector<std::byte> answer = std::move(bytes).value();
    // A short read gives the report's beginning, as a control transfer does.
    if (answer.size() > size) answer.resize(size);
    return answer;
}

}  // namespace foverig
