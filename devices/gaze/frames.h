#pragma once
// SGZ1 frames on the wire, version 1.0 (DEVICES.md 4.5.2-4.5.5): a 32-byte header, a body by type,
// a CRC. Times are ns of the device clock. Positions mm and directions in the wire's frame:
// x left, y up, z forward, origin midway between the lens centres; missing numbers are NaN.
#include <array>
#include <cstdint>
#include <limits>
#include <variant>
#include <vector>

#include "devices/bytes.h"
#include "devices/result.h"

namespace foverig::gaze {

constexpr float kNotMeasured = std::numeric_limits<float>::quiet_NaN();

enum class FrameType : std::uint8_t { sample = 1, event = 2, calibration = 3, heartbeat = 4 };

/// Bits of FrameHeader::flags.
namespace frame_flag {
constexpr std::uint8_t simulated = 1, replayed = 2, por_filter = 4, discontinuity = 8,
                       clock_reset = 16, binocular_low_pass = 32;
}

/// Length, header length and type are written by `encode`.
struct FrameHeader {
    static constexpr std::size_t kSize = 32;
    static constexpr std::uint8_t kMajor = 1, kMinor = 0;

    std::uint8_t flags = 0;
    std::uint32_t sequence = 0;   ///< +1 for each frame of any type since START, wraps
    std::uint64_t queued_ns = 0;  ///< given to USB
    std::uint32_t session = 0;
    bool operator==(const FrameHeader&) const = default;
};

using Vec2f = std::array<float, 2>;
using Vec3f = std::array<float, 3>;

enum class EyeState : std::uint8_t { invalid = 0, visible = 1, compensated = 2, tracked = 3 };
enum class EyeCause : std::uint8_t {
    none = 0,
    blink,
    out_of_range,
    glint_lost,
    pupil_lost,
    headset_off,
    simulated_fault
};

struct EyeBlock {
    static constexpr std::size_t kSize = 68;

    Vec3f base_point_mm{kNotMeasured, kNotMeasured, kNotMeasured};
    Vec3f direction{kNotMeasured, kNotMeasured, kNotMeasured};  ///< unit
    Vec2f por_px{kNotMeasured, kNotMeasured};                   ///< of 1920x1080, (0,0) top-left
    Vec3f pupil_mm{kNotMeasured, kNotMeasured, kNotMeasured};
    float pupil_radius_mm = kNotMeasured;
    float lens_distance_mm = kNotMeasured;
    float screen_distance_mm = kNotMeasured;
    float openness = kNotMeasured;  ///< 0..1
    float confidence = 0;           ///< 0..1
    EyeState state = EyeState::invalid;
    EyeCause cause = EyeCause::none;
};

/// Bits of SampleFrame::status.
namespace sample_status {
constexpr std::uint16_t valid = 1, left_valid = 2, right_valid = 4, combined_valid = 8,
                        left_blink = 16, right_blink = 32, saccade = 64, calibrating = 128,
                        dynamic_mapping = 256, uncalibrated = 512;
}

/// Type 1.
struct SampleFrame {
    static constexpr FrameType kType = FrameType::sample;
    static constexpr std::size_t kSize = 248;
    static constexpr std::int16_t kNoTemperature = std::numeric_limits<std::int16_t>::min();

    FrameHeader header{};
    std::uint64_t exposure_ns = 0;   ///< mid-exposure of the eye cameras
    std::uint32_t camera_frame = 0;  ///< counts exposures, sent or not
    std::uint16_t rate_decihertz = 600;
    std::uint16_t status = 0;
    float iod_mm = kNotMeasured, ipd_mm = kNotMeasured;
    Vec3f base_point_mm{kNotMeasured, kNotMeasured, kNotMeasured};  ///< combined ray
    Vec3f direction{kNotMeasured, kNotMeasured, kNotMeasured};
    Vec2f por_px{kNotMeasured, kNotMeasured};
    EyeBlock left{}, right{};
    float mapping_distance_mm = 1500;
    float vergence_distance_mm = kNotMeasured;
    std::int16_t temperature_centi_c = kNoTemperature;
    std::uint16_t calibration_id = 0;
    std::uint8_t calibration_points = 0;
    std::uint8_t calibration_quality = 255;  ///< 0..100, 255 unknown
    std::uint32_t dropped_by_device = 0;

    std::array<std::byte, kSize> encode() const;
};

enum class EventKind : std::uint8_t { fixation = 1, saccade, blink, pursuit, loss };
enum class EventEye : std::uint8_t { combined = 0, left, right };
enum class EventPhase : std::uint8_t { start = 0, update, end };

/// Type 2.
struct EventFrame {
    static constexpr FrameType kType = FrameType::event;
    static constexpr std::size_t kSize = 104;

    FrameHeader header{};
    std::uint64_t start_ns = 0, end_ns = 0;  ///< end 0 while going on
    EventKind kind = EventKind::fixation;
    EventEye eye = EventEye::combined;
    EventPhase phase = EventPhase::start;
    Vec3f direction_at_start{kNotMeasured, kNotMeasured, kNotMeasured};
    Vec3f direction_at_end{kNotMeasured, kNotMeasured, kNotMeasured};
    float amplitude_deg = kNotMeasured, peak_deg_s = kNotMeasured;
    Vec2f mean_por_px{kNotMeasured, kNotMeasured};
    std::uint32_t first_camera_frame = 0, last_camera_frame = 0;

    std::array<std::byte, kSize> encode() const;
};

enum class CalibrationState : std::uint8_t {
    idle = 0,
    waiting,
    collecting,
    point_accepted,
    point_rejected,
    done,
    failed,
    aborted
};
enum class CalibrationReason : std::uint8_t { none = 0, no_eyes, unstable, timed_out, host_abort };

/// Type 3.
struct CalibrationFrame {
    static constexpr FrameType kType = FrameType::calibration;
    static constexpr std::size_t kSize = 80;

    FrameHeader header{};
    std::uint32_t calibration_id = 0;
    std::uint8_t points = 0, current_point = 0;
    CalibrationState state = CalibrationState::idle;
    CalibrationReason reason = CalibrationReason::none;
    Vec2f target_por_px{kNotMeasured, kNotMeasured};
    Vec3f target_direction{kNotMeasured, kNotMeasured, kNotMeasured};
    Vec2f accuracy_deg{kNotMeasured, kNotMeasured};   ///< left, right; NaN until done
    Vec2f precision_deg{kNotMeasured, kNotMeasured};  ///< RMS sample to sample

    std::array<std::byte, kSize> encode() const;
};

/// Type 4, 1 Hz while streaming.
struct HeartbeatFrame {
    static constexpr FrameType kType = FrameType::heartbeat;
    static constexpr std::size_t kSize = 52;

    FrameHeader header{};
    std::uint64_t now_ns = 0;
    std::uint32_t usb_sof = 0xFFFFFFFF;
    std::uint32_t samples_sent = 0;

    std::array<std::byte, kSize> encode() const;
};

using Frame = std::variant<SampleFrame, EventFrame, CalibrationFrame, HeartbeatFrame>;

/// A whole transfer: magic, version, both lengths, CRC and type are checked in this order. Newer
/// minor versions may be longer. Codes and numbers of the body are not judged here.
Result<Frame> decode_frame(Bytes transfer);

}  // namespace foverig::gaze
