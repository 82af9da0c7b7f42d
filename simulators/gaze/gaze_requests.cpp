// GazeFirmware's side of the vendor requests (DEVICES.md 4.5.6).
#include <fmt/format.h>

#include <cmath>

#include "simulators/gaze/gaze_firmware.h"

namespace foverig {
namespace {

using gaze::DeviceState;
namespace capability = gaze::capability;
namespace request = gaze::request;

constexpr auto kTimeJumpAfter = std::chrono::seconds(5);
constexpr std::uint64_t kSessionStream = 820;
constexpr float kMostDrift_ppm = 1e5F;

}  // namespace

Error GazeFirmware::stall(const std::string& why) {
    return {ErrorCode::unsupported, "the simulated gaze tracker stalls: " + why};
}

Status GazeFirmware::start(HostTime now) {
    if (running()) return stall("START while streaming");
    ++sessions_;
    status_.state = DeviceState::streaming;
    // A device that was plugged in anew does not draw the same numbers again.
    const auto plugged_in_ns =
        static_cast<std::uint64_t>(settings_.plugged_in.time_since_epoch().count());
    status_.session = static_cast<std::uint32_t>(
        motion::Draws(settings_.seed, kSessionStream).bits(sessions_ + plugged_in_ns));
    status_.sent = 0;
    sequence_ = 0;
    exposures_ = 0;
    measured_.clear();
    next_flags_ = gaze::frame_flag::discontinuity;
    started_ = now;
    next_heartbeat_ = now + kHeartbeatPeriod;
    if (settings_.faults.time_jump != 0.0) clock_jump_at_ = now + kTimeJumpAfter;
    return Done{};
}

void GazeFirmware::stop() {
    status_.state = DeviceState::idle;
    measured_.clear();
    points_.reset();
    told_.clear();
}

Status GazeFirmware::set_rate(std::uint16_t hz) {
    if (running()) return stall("SET_RATE while streaming");
    if (hz != 60 && hz != 120 && hz != 250) {
        return stall(fmt::format("SET_RATE {}; expected 60, 120 or 250", hz));
    }
    rate_hz_ = hz;
    status_.rate_decihertz = static_cast<std::uint16_t>(10 * hz);
    return Done{};
}

Status GazeFirmware::order(const gaze::SimFault& fault, HostTime now) {
    switch (fault.kind) {
        case gaze::FaultKind::drop_frame:
            orders_.drop += fault.count;
            return Done{};
        case gaze::FaultKind::crc_error:
            orders_.spoil += fault.count;
            return Done{};
        case gaze::FaultKind::duplicate:
            orders_.repeat += fault.count;
            return Done{};
        case gaze::FaultKind::time_jump:
            jump_clock(from_seconds(1e-3 * static_cast<double>(fault.p1)));
            return Done{};
        case gaze::FaultKind::eye_lost:
            orders_.eyes_lost_until = now + std::chrono::milliseconds(fault.duration_ms);
            return Done{};
        case gaze::FaultKind::blink:
            return order_blink(fault, now);
        case gaze::FaultKind::stall:
            orders_.stall += fault.count;
            return Done{};
        case gaze::FaultKind::clock_drift:
            if (!(std::abs(fault.p1) <= kMostDrift_ppm)) return stall("a drift that no clock has");
            drift(static_cast<double>(fault.p1), now);
            return Done{};
        default:
            return stall(fmt::format("SIM_FAULT {}", static_cast<int>(fault.kind)));
    }
}

/// p1 says whose, in an event's numbers: 0 both, 1 left, 2 right (ours: the protocol leaves it
/// open).
Status GazeFirmware::order_blink(const gaze::SimFault& fault, HostTime now) {
    if (fault.p1 == 0.0F) {
        orders_.blink_of.reset();
    } else if (fault.p1 == 1.0F || fault.p1 == 2.0F) {
        orders_.blink_of = fault.p1 == 1.0F ? Side::left : Side::right;
    } else {
        return stall("a blink of an eye that nobody has");
    }
    orders_.blink_until = now + std::chrono::milliseconds(fault.duration_ms);
    return Done{};
}

bool GazeFirmware::stalls_as_ordered() {
    return orders_.stall > 0 && orders_.stall-- > 0;
}

Status GazeFirmware::set(std::uint8_t id, std::uint16_t value, Bytes data, HostTime now) {
    if (stalls_as_ordered()) return stall("as it was ordered to");
    switch (id) {
        case request::start:
            return start(now);
        case request::stop:
            stop();
            return Done{};
        case request::set_rate:
            return set_rate(value);
        case request::set_options: {
            const auto options = gaze::decode_options(data);
            if (!options) return options.error();
            status_.options = *options;
            return Done{};
        }
        case request::set_mapping: {
            const auto mapping_mm = gaze::decode_mapping(data);
            if (!mapping_mm) return mapping_mm.error();
            status_.mapping_mm = *mapping_mm;
            return Done{};
        }
        case request::cal_start:
            return start_calibration(value, data, now);
        case request::cal_accept:
            return accept_point(data, now);
        case request::cal_abort:
            return abort_points(now);
        case request::cal_blob:
            return set_calibration(data);
        case request::validate:
            return validate(value, data, now);
        case request::sim_fault: {
            const auto fault = gaze::SimFault::decode(data);
            if (!fault) return fault.error();
            return order(*fault, now);
        }
        default:
            return stall(fmt::format("OUT request {:#04x}", id));
    }
}

Result<std::vector<std::byte>> GazeFirmware::get(std::uint8_t id, std::uint16_t value,
                                                 HostTime now) {
    if (stalls_as_ordered()) return stall("as it was ordered to");
    switch (id) {
        case request::get_info:
            return to_vector(
                gaze::Info{.rates = 0b111,
                           .capabilities = capability::openness | capability::save_calibration |
                                           capability::dynamic_mapping | capability::simulator,
                           .serial = "FOVERIGSIM000001",
                           .firmware = "simulated",
                           .nominal_latency_us = 12000}
                    .encode());
        case request::get_status:
            return to_vector(status_.encode());
        case request::get_time:
            return to_vector(gaze::DeviceTimeReply{
                .device_ns = static_cast<std::uint64_t>(clock_.at_ns(now)), .cookie = value}
                                 .encode());
        case request::cal_blob:
            return to_vector(calibration().encode());
        default:
            return stall(fmt::format("IN request {:#04x}", id));
    }
}

}  // namespace foverig
