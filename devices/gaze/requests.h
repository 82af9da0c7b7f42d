#pragma once
// Vendor control requests of the gaze tracker (DEVICES.md 4.5.6) and their payloads.
// `Transport::control_set/get` take the request as `id` and wValue as `value`.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "devices/bytes.h"
#include "devices/gaze/frames.h"
#include "devices/result.h"

namespace foverig::gaze {

namespace request {
constexpr std::uint8_t get_info = 0x01, get_status = 0x02, get_time = 0x03, start = 0x10,
                       stop = 0x11, set_rate = 0x12, set_options = 0x13, set_mapping = 0x14,
                       cal_start = 0x20, cal_accept = 0x21, cal_abort = 0x22, cal_blob = 0x23,
                       validate = 0x24, sim_fault = 0x70, reset = 0x7F;
}
constexpr std::uint16_t kResetKey = 0xA5A5;  ///< wValue of RESET

/// Bits of Info::capabilities.
namespace capability {
constexpr std::uint32_t events = 1, openness = 2, save_calibration = 4, dynamic_mapping = 8,
                        simulator = 16;
}

/// GET_INFO.
struct Info {
    static constexpr std::size_t kSize = 64;

    std::uint8_t major = 1, minor = 0;
    std::uint16_t rates = 0b001;  ///< bit 0: 60, bit 1: 120, bit 2: 250 Hz
    std::uint32_t capabilities = 0;
    std::string serial{}, firmware{};  ///< up to 16 ASCII characters
    std::uint16_t display_width_px = 1920, display_height_px = 1080;
    std::uint32_t clock_hz = 1000000000;
    std::uint32_t nominal_latency_us = 0;

    static Result<Info> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const Info&) const = default;
};

enum class DeviceState : std::uint8_t { idle = 0, streaming, calibrating, fault };

/// GET_STATUS.
struct DeviceStatus {
    static constexpr std::size_t kSize = 32;

    DeviceState state = DeviceState::idle;
    std::uint8_t last_error = 0;  ///< ours: CalibrationReason of the last point that was refused
    std::uint16_t rate_decihertz = 600;
    std::uint32_t session = 0, sent = 0, dropped = 0;
    std::uint16_t calibration_id = 0;
    std::uint8_t calibration_points = 0, calibration_quality = 255;
    float mapping_mm = 1500;
    std::uint32_t options = 0;

    static Result<DeviceStatus> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const DeviceStatus&) const = default;
};

/// GET_TIME; the cookie is the request's wValue, so that an answer cannot be taken for another's.
struct DeviceTimeReply {
    static constexpr std::size_t kSize = 16;

    std::uint64_t device_ns = 0;
    std::uint16_t cookie = 0;

    static Result<DeviceTimeReply> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const DeviceTimeReply&) const = default;
};

/// SET_OPTIONS bits.
namespace option {
constexpr std::uint32_t disable_por_filter = 1, events = 2, binocular_low_pass = 4;
}
std::array<std::byte, 4> encode_options(std::uint32_t options);
Result<std::uint32_t> decode_options(Bytes bytes);

/// SET_MAPPING: mm, more than 0; +infinity maps at the vergence distance.
std::array<std::byte, 4> encode_mapping(float distance_mm);
Result<float> decode_mapping(Bytes bytes);

/// CAL_GET and CAL_SET: a calibration as the tracker keeps it, which only the tracker understands.
struct CalibrationBlob {
    static constexpr std::size_t kSize = 512;
    static constexpr std::size_t kMostData = kSize - 12;  ///< without magic, length, id and CRC

    std::uint16_t id = 0;
    std::vector<std::byte> data{};  ///< at most kMostData

    static Result<CalibrationBlob> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const CalibrationBlob&) const = default;
};

/// Points that CAL_START may be asked for; 0 forgets the calibration.
constexpr std::array<int, 6> kCalibrationPoints{0, 1, 3, 5, 9, 13};

/// Targets of CAL_START, CAL_ACCEPT and VALIDATE: pairs of POR px.
std::vector<std::byte> encode_targets(std::span<const Vec2f> por_px);
Result<std::vector<Vec2f>> decode_targets(Bytes bytes);

enum class FaultKind : std::uint16_t {
    drop_frame = 1,
    crc_error,
    duplicate,
    time_jump,
    blink,
    eye_lost,
    unplug,
    stall,
    clock_drift
};

/// SIM_FAULT, simulators only.
struct SimFault {
    static constexpr std::size_t kSize = 16;

    FaultKind kind = FaultKind::drop_frame;
    std::uint16_t count = 1;
    float p1 = 0, p2 = 0;
    std::uint32_t duration_ms = 0;

    static Result<SimFault> decode(Bytes bytes);
    std::array<std::byte, kSize> encode() const;
    bool operator==(const SimFault&) const = default;
};

}  // namespace foverig::gaze
