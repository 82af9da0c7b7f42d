#include "simulators/faults/faults.h"

#include <fmt/format.h>

#include <array>
#include <string>

namespace foverig {
namespace {

template <auto Group, auto Member>
double& field(FaultSettings& faults) {
    return faults.*Group.*Member;
}

using F = FaultSettings;
using D = Dk2Faults;
using G = GazeFaults;
using P = PanelFaults;
using C = CameraFaults;

constexpr std::array kFaults{
    FaultInfo{"dk2", "noise", "x", "white noise of gyro and accelerometer, times the chip's", 1.0,
              0.0, 1e3, field<&F::dk2, &D::noise>},
    FaultInfo{"dk2", "low_pass", "Hz", "the gyro's low-pass filter", 250.0, 0.0, 500.0,
              field<&F::dk2, &D::low_pass>},
    FaultInfo{"dk2", "quantise", "0|1", "steps of the chip, clipped at 2000 deg/s and 4 g", 1.0,
              0.0, 1.0, field<&F::dk2, &D::quantise>},
    FaultInfo{"dk2", "bias", "deg/s", "gyro bias, drawn per axis up to this", 0.2, 0.0, 50.0,
              field<&F::dk2, &D::bias>},
    FaultInfo{"dk2", "factory", "of the limits",
              "raw offsets, scale and cross-axis errors, which the factory calibration corrects",
              1.0, 0.0, 1.0, field<&F::dk2, &D::factory>},
    FaultInfo{"dk2", "scale", "%", "scale and cross-axis error, drawn up to this", 3.0, 0.0, 20.0,
              field<&F::dk2, &D::scale>},
    FaultInfo{"dk2", "temperature_drift", "deg/s/C", "gyro bias from 25 to 38 C in 8 min", 0.01,
              0.0, 10.0, field<&F::dk2, &D::temperature_drift>},
    FaultInfo{"dk2", "temperature_table", "0|1",
              "the headset has stored its gyro bias by temperature (no fault: a cure)", 1.0, 0.0,
              1.0, field<&F::dk2, &D::temperature_table>},
    FaultInfo{"dk2", "random_walk", "rad/s2/rtHz", "random walk of the gyro bias", 3e-5, 0.0, 1.0,
              field<&F::dk2, &D::random_walk>},
    FaultInfo{"dk2", "clock_drift", "ppm", "the device's clock against the host's", 20.0, -1e4, 1e4,
              field<&F::dk2, &D::clock_drift>},
    FaultInfo{"dk2", "clock_wander", "ppm", "slow wander of the device's clock, rms", 5.0, 0.0, 1e3,
              field<&F::dk2, &D::clock_wander>},
    FaultInfo{"dk2", "rate_error", "ppm", "the IMU's own period against 1000 us", 3000.0, -2e4, 2e4,
              field<&F::dk2, &D::rate_error>},
    FaultInfo{"dk2", "jitter", "us", "sample instants, drawn up to this either way", 2.0, 0.0,
              200.0, field<&F::dk2, &D::jitter>},
    FaultInfo{"dk2", "host_delay", "ms", "late wake-up of the host, exponential, mean", 0.2, 0.0,
              1e3, field<&F::dk2, &D::host_delay>},
    FaultInfo{"dk2", "dropout", "chance", "a report is lost on its way", 0.01, 0.0, 1.0,
              field<&F::dk2, &D::dropout>},
    FaultInfo{"dk2", "dropout_burst", "reports", "with dropout: mean length of a loss", 5.0, 0.0,
              1e4, field<&F::dk2, &D::dropout_burst>},
    FaultInfo{"dk2", "backwards_stamp", "chance", "a report's stamp lies 3 ms back", 0.001, 0.0,
              1.0, field<&F::dk2, &D::backwards_stamp>},
    FaultInfo{"dk2", "unplug_at", "s", "with unplug_for: when the cable is pulled", 5.0, 0.0, 1e6,
              field<&F::dk2, &D::unplug_at>},
    FaultInfo{"dk2", "unplug_for", "s", "how long the cable stays out; 0 is never pulled", 1.0, 0.0,
              1e6, field<&F::dk2, &D::unplug_for>},
    FaultInfo{"dk2", "wrap", "s", "time until the 32-bit stamp wraps", 30.0, 0.0, 4294.0,
              field<&F::dk2, &D::wrap>},
    FaultInfo{"gaze", "noise", "deg", "noise per eye at the centre", 0.12, 0.0, 20.0,
              field<&F::gaze, &G::noise>},
    FaultInfo{"gaze", "offset", "deg", "constant error per axis and eye", 0.4, 0.0, 20.0,
              field<&F::gaze, &G::offset>},
    FaultInfo{"gaze", "crosstalk", "deg", "quadratic error at 20 degrees", 0.5, 0.0, 20.0,
              field<&F::gaze, &G::crosstalk>},
    FaultInfo{
        "gaze", "user", "x",
        "the user's eyes against the tracker's model: kappa, gain, roll; it starts uncalibrated",
        1.0, 0.0, 2.0, field<&F::gaze, &G::user>},
    FaultInfo{"gaze", "slip", "deg/min", "slow slip of the headset", 0.1, 0.0, 60.0,
              field<&F::gaze, &G::slip>},
    FaultInfo{"gaze", "latency_jitter", "ms", "spread of the tracker's 12 ms, up to 30 ms", 1.5,
              0.0, 10.0, field<&F::gaze, &G::latency_jitter>},
    FaultInfo{"gaze", "dropout", "chance", "a frame is lost on the wire", 0.02, 0.0, 1.0,
              field<&F::gaze, &G::dropout>},
    FaultInfo{"gaze", "lost_exposure", "chance", "the tracker loses an exposure", 0.02, 0.0, 1.0,
              field<&F::gaze, &G::lost_exposure>},
    FaultInfo{"gaze", "blink", "1/min", "blinks", 14.0, 0.0, 100.0, field<&F::gaze, &G::blink>},
    FaultInfo{"gaze", "crc_error", "chance", "a frame arrives with a wrong bit", 0.001, 0.0, 1.0,
              field<&F::gaze, &G::crc_error>},
    FaultInfo{"gaze", "duplicate", "chance", "a frame arrives twice", 0.001, 0.0, 1.0,
              field<&F::gaze, &G::duplicate>},
    FaultInfo{"gaze", "time_jump", "ms", "the device's clock jumps once, 5 s after START", 500.0,
              -1e6, 1e6, field<&F::gaze, &G::time_jump>},
    FaultInfo{"gaze", "clock_drift", "ppm", "the device's clock against the host's", 20.0, -1e4,
              1e4, field<&F::gaze, &G::clock_drift>},
    FaultInfo{"gaze", "unplug_at", "s", "with unplug_for: when the cable is pulled", 5.0, 0.0, 1e6,
              field<&F::gaze, &G::unplug_at>},
    FaultInfo{"gaze", "unplug_for", "s", "how long the cable stays out; 0 is never pulled", 1.0,
              0.0, 1e6, field<&F::gaze, &G::unplug_for>},
    FaultInfo{"panel", "vsync_jitter", "us", "jitter of the vsync instants", 10.0, 0.0, 1000.0,
              field<&F::panel, &P::vsync_jitter>},
    FaultInfo{"panel", "lost_readback", "chance", "a read of the corner pixel is lost", 0.01, 0.0,
              1.0, field<&F::panel, &P::lost_readback>},
    FaultInfo{"camera", "noise", "x", "read and shot noise, times the sensor's", 1.0, 0.0, 100.0,
              field<&F::camera, &C::noise>},
    FaultInfo{"camera", "dropout", "chance", "a frame is lost", 0.02, 0.0, 1.0,
              field<&F::camera, &C::dropout>},
    FaultInfo{"camera", "spots", "spots", "lights in the room that are no LEDs", 8.0, 0.0, 100.0,
              field<&F::camera, &C::spots>},
    FaultInfo{"camera", "occlude_at", "s", "with occlude_for: when the LEDs are covered", 5.0, 0.0,
              1e6, field<&F::camera, &C::occlude_at>},
    FaultInfo{"camera", "occlude_for", "s", "how long they are covered; 0 is never", 2.0, 0.0, 1e6,
              field<&F::camera, &C::occlude_for>},
    FaultInfo{"camera", "unplug_at", "s", "with unplug_for: when the cable is pulled", 5.0, 0.0,
              1e6, field<&F::camera, &C::unplug_at>},
    FaultInfo{"camera", "unplug_for", "s", "how long the cable stays out; 0 is never pulled", 1.0,
              0.0, 1e6, field<&F::camera, &C::unplug_for>},
};

}  // namespace

std::span<const FaultInfo> known_faults() {
    return kFaults;
}

Status set_fault(FaultSettings& faults, std::string_view device, std::string_view kind,
                 double value) {
    std::string kinds;
    for (const FaultInfo& info : kFaults) {
        if (info.device != device) continue;
        kinds += fmt::format("{}{}", kinds.empty() ? "" : ", ", info.kind);
        if (info.kind != kind) continue;
        if (!(value >= info.low && value <= info.high)) {
            return Error{ErrorCode::invalid_data,
                         fmt::format("faults.{}.{} = {} is out of range; expected {} to {} {}",
                                     device, kind, value, info.low, info.high, info.unit)};
        }
        info.field(faults) = value;
        return Done{};
    }
    if (kinds.empty()) {
        return Error{
            ErrorCode::not_found,
            fmt::format("faults.{}: no such device; expected dk2, gaze, panel or camera", device)};
    }
    return Error{
        ErrorCode::not_found,
        fmt::format("faults.{}.{}: no such fault; expected one of {}", device, kind, kinds)};
}

}  // namespace foverig
