#pragma once
// What can go wrong with a device, each off until a scenario names it. A fault of 0 costs nothing
// and changes no byte. The scenario's keys are faults.<device>.<kind>.
#include <span>
#include <string_view>

#include "devices/result.h"

namespace foverig {

/// DEVICES.md 6.2. Scale, bias and drift are what the factory calibration has left.
struct Dk2Faults {
    double noise = 0.0;              ///< times the chip's density
    double low_pass = 0.0;           ///< Hz, gyro
    double quantise = 0.0;           ///< steps of the chip, and its ranges' ends
    double factory = 0.0;            ///< share of the factory's limits; report 3 corrects it
    double bias = 0.0;               ///< deg/s, gyro, per axis
    double scale = 0.0;              ///< %, both sensors, per matrix element
    double temperature_drift = 0.0;  ///< deg/s per degree C, gyro
    double temperature_table = 0.0;  ///< the headset has stored its gyro offsets by temperature
    double random_walk = 0.0;        ///< rad/s^2/sqrt(Hz), gyro bias
    double clock_drift = 0.0;        ///< ppm
    double clock_wander = 0.0;       ///< ppm, root mean square
    double rate_error = 0.0;         ///< ppm of the IMU's own clock against the device's
    double jitter = 0.0;             ///< us, sample instants
    double host_delay = 0.0;         ///< ms, mean of the host's late wake-up
    double dropout = 0.0;            ///< chance that a report is lost
    double dropout_burst = 0.0;      ///< reports lost at a time, mean
    double backwards_stamp = 0.0;    ///< chance that a report's stamp goes back by 3 ms
    double unplug_at = 0.0;          ///< s
    double unplug_for = 0.0;         ///< s
    double wrap = 0.0;               ///< s from the start until the 32-bit stamp wraps
};

/// DEVICES.md 5.4 and 5.5.
struct GazeFaults {
    double noise = 0.0;           ///< deg, standard deviation per eye at the centre
    double offset = 0.0;          ///< deg, standard deviation per axis and eye
    double crosstalk = 0.0;       ///< deg at 20 degrees of eccentricity, quadratic
    double user = 0.0;            ///< times what sets a person's eyes apart (gaze/user_eye.h)
    double slip = 0.0;            ///< deg per minute
    double latency_jitter = 0.0;  ///< ms
    double dropout = 0.0;         ///< chance that a frame is lost on the wire
    double lost_exposure = 0.0;   ///< chance that the tracker loses an exposure
    double blink = 0.0;           ///< per minute
    double crc_error = 0.0;       ///< chance
    double duplicate = 0.0;       ///< chance
    double time_jump = 0.0;       ///< ms, once, 5 s after START
    double clock_drift = 0.0;     ///< ppm
    double unplug_at = 0.0;       ///< s
    double unplug_for = 0.0;      ///< s
};

/// The tracker camera (DEVICES.md 1.8).
struct CameraFaults {
    double noise = 0.0;        ///< times the sensor's read and shot noise
    double dropout = 0.0;      ///< chance that a frame is lost
    double spots = 0.0;        ///< lights in the room that are no LEDs
    double occlude_at = 0.0;   ///< s
    double occlude_for = 0.0;  ///< s
    double unplug_at = 0.0;    ///< s
    double unplug_for = 0.0;   ///< s
};

/// DEVICES.md 1.7, 2.3.
struct PanelFaults {
    double vsync_jitter = 0.0;   ///< us, standard deviation
    double lost_readback = 0.0;  ///< chance
};

struct FaultSettings {
    Dk2Faults dk2;
    GazeFaults gaze;
    PanelFaults panel;
    CameraFaults camera;
};

struct FaultInfo {
    std::string_view device, kind, unit, meaning;
    double typical;    ///< the documents' figure, to try first
    double low, high;  ///< allowed values
    double& (*field)(FaultSettings&);
};

std::span<const FaultInfo> known_faults();

/// Sets faults.<device>.<kind>; an unknown name or a value out of range gives one sentence.
Status set_fault(FaultSettings& faults, std::string_view device, std::string_view kind,
                 double value);

}  // namespace foverig
