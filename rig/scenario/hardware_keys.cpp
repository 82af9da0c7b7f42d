#include "rig/scenario/hardware_keys.h"

#include "devices/hardware/identity.h"
#include "rig/scenario/key_makers.h"

namespace foverig {
namespace {

Key usb_id_key() {
    Key key = text_key(
        "hardware.gaze_usb_id", "VENDOR:PRODUCT, four hexadecimal digits each, as in 1209:0001",
        "what the gaze tracker is known by on the bus",
        [](auto& s) -> auto& { return s.hardware.gaze_usb_id; });
    key.set = [expected = key.expected](Scenario& s,
                                        const KeyValue& v) -> std::optional<std::string> {
        const auto& text = std::get<std::string>(v);
        if (!hardware::usb_id_of(text)) return expected;
        s.hardware.gaze_usb_id = text;
        return std::nullopt;
    };
    return key;
}

/// What SGZ1 knows; whether the tracker has it is known when it is opened.
Key gaze_rate_key() {
    Key key = integer_key(
        "tracking.gaze_rate_hz", "Hz", {},
        "samples per second that the gaze tracker is set to; a recording keeps its own",
        [](auto& s) -> auto& { return s.tracking.gaze_rate_hz; });
    key.expected = "60, 120 or 250 (Hz)";
    key.set = [expected = key.expected](Scenario& s,
                                        const KeyValue& v) -> std::optional<std::string> {
        const auto rate_hz = std::get<std::int64_t>(v);
        if (rate_hz != 60 && rate_hz != 120 && rate_hz != 250) return expected;
        s.tracking.gaze_rate_hz = static_cast<int>(rate_hz);
        return std::nullopt;
    };
    return key;
}

}  // namespace

void add_hardware_keys(std::vector<Key>& keys) {
    keys.push_back(choice_key(
        "hardware.head", {"required", "auto", "sim"},
        "with devices = hardware: a headset must be there; auto: simulated where there is none; "
        "sim: simulated",
        [](auto& s) -> auto& { return s.hardware.head; }));
    keys.push_back(choice_key(
        "hardware.gaze", {"required", "auto", "sim"}, "the same for the gaze tracker",
        [](auto& s) -> auto& { return s.hardware.gaze; }));
    keys.push_back(choice_key(
        "hardware.camera", {"required", "auto", "sim"},
        "the same for the tracker camera, where tracking.camera is true; sim goes with a simulated "
        "headset",
        [](auto& s) -> auto& { return s.hardware.camera; }));
    keys.push_back(text_key(
        "hardware.head_serial", "a serial or factory number (foverig devices)",
        "which headset; empty: the only one",
        [](auto& s) -> auto& { return s.hardware.head_serial; }));
    keys.push_back(text_key(
        "hardware.gaze_serial", "a serial (foverig devices)",
        "which gaze tracker; empty: the only one",
        [](auto& s) -> auto& { return s.hardware.gaze_serial; }));
    keys.push_back(text_key(
        "hardware.camera_serial", "a serial (foverig devices)",
        "which tracker camera; empty: the only one",
        [](auto& s) -> auto& { return s.hardware.camera_serial; }));
    keys.push_back(usb_id_key());
    keys.push_back(flag_key(
        "tracking.camera",
        "the headset's LEDs blink and the tracker camera holds position and yaw; false: inertial "
        "sensor alone",
        [](auto& s) -> auto& { return s.tracking.camera; }));
    keys.push_back(gaze_rate_key());
    keys.push_back(text_key(
        "tracking.gaze_calibration", "a file that foverig calibrate wrote",
        "calibration that the gaze tracker is given; empty: the one that it has",
        [](auto& s) -> auto& { return s.tracking.gaze_calibration; }));
    keys.push_back(number_key(
        "tracking.gaze_added_latency_ms", "ms", {0.0, 1000.0},
        "frames of the gaze tracker come so much later, simulated, replayed or real",
        [](auto& s) -> auto& { return s.tracking.gaze_added_latency_ms; }));
    keys.push_back(number_key(
        "tracking.gaze_added_noise_deg", "deg", {0.0, 20.0},
        "standard deviation of noise on top of the gaze tracker's angles, the same way",
        [](auto& s) -> auto& { return s.tracking.gaze_added_noise_deg; }));
}

}  // namespace foverig
