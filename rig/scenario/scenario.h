#pragma once
// Everything that decides what a run does. Defaults are the built-in scenario.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/settings.h"
#include "simulators/faults/faults.h"

namespace foverig {

struct DisplaySettings {
    std::string kind = "virtual";
    double rate_hz = 75.0;  ///< DK2 (DEVICES.md 2.3)
    int eyes = 2;
    int eye_width_px = 1182;  ///< DK2 at density 1 (DEVICES.md 2.2)
    int eye_height_px = 1464;
    bool distortion = true;        ///< lens distortion with chromatic correction as a pass
    std::string pacing = "vsync";  ///< vsync: begin a frame at a VSync; free: as soon as possible
};

/// Places are in the file's coordinates, in metres.
struct CameraSettings {
    std::string path =
        "scene";  ///< scene: fly the scene's own path; keys: fly keys_m; still: stand
    std::vector<double> position_m;  ///< where to stand; empty: the first key of the scene's path
    std::vector<double> target_m;    ///< where to look
    std::vector<double> keys_m;      ///< position and target of each key, six numbers a key
    double one_way_s = 0.0;          ///< time of one flight; 0: the scene's
};

/// Lights beside the scene's own, in the file's coordinates, in metres.
struct LightSettings {
    bool keep = true;              ///< false: leave the scene's own lights out
    std::vector<double> points_m;  ///< three numbers a light
    double point_intensity = 1.0;  ///< W/sr of each
    std::vector<double> areas_m;   ///< corner, edge, edge: nine numbers a light
    double area_radiance = 1.0;
};

/// A value of motion.gaze: the eyes follow the cursor of a window.
inline constexpr const char* kMouseGaze = "mouse";

struct MotionSettings {
    std::string head = "look";
    std::string gaze = "scan";
};

/// Of `display.kind` window (on the desktop) and headset (full screen on the DK2's monitor).
struct WindowSettings {
    int width_px = 1280;     ///< of a window; its height is 9/16 of that
    std::string monitor;     ///< of full screen; empty: the one that looks like a DK2
    bool wait_vsync = true;  ///< swap interval 1
    bool late_warp = true;   ///< turn the pictures to the newest head pose before the lens
    bool hud = false;        ///< shown from the start
};

inline constexpr std::size_t kMostKeptFrames = 24;  ///< they are held in memory: 42 MB each

struct ImageSettings {
    int count = 3;                     ///< frames to keep images of, spread over the run
    std::vector<std::int64_t> frames;  ///< exactly these instead
    bool error = true;                 ///< render them again in full and show the difference
};

struct RecordingSettings {
    bool enabled = false;
    bool decoded = true;               ///< samples beside the bytes they came from, for plots
    std::string compression = "none";  ///< of the file's chunks: none or zstd
};

/// Of `devices = "hardware"`. head and gaze: required; auto (simulated where there is none); sim.
struct HardwareSettings {
    std::string head = "required";
    std::string gaze = "required";
    std::string camera = "required";  ///< the tracker camera, where tracking.camera is on
    std::string head_serial;          ///< empty: the only one that is plugged in
    std::string gaze_serial;
    std::string camera_serial;
    std::string gaze_usb_id = "1209:0001";
};

/// How head and eyes are followed.
struct TrackingSettings {
    bool camera = false;    ///< the tracker camera holds position and yaw; else the gyro alone
    int gaze_rate_hz = 60;  ///< of the gaze tracker's samples: 60, 120 or 250
    std::string gaze_calibration;        ///< `foverig calibrate`'s file; empty: the tracker's own
    double gaze_added_latency_ms = 0.0;  ///< of whatever gaze tracker there is, recorded or not
    double gaze_added_noise_deg = 0.0;   ///< standard deviation of each eye's angles
};

/// Of `devices = "replay:FILE"`.
struct ReplaySettings {
    double speed = 1.0;  ///< of the wall clock against the recording's
    bool loop = false;   ///< begin again at the recording's end
};

/// A camera on the headset whose picture a window shows where rays met nothing. Off without one.
struct SeeThroughSettings {
    std::string camera;           ///< sim, a node ("/dev/video0") or a USB identifier ("046d:0825")
    double fov_deg = 60.0;        ///< horizontal; where lens_px tells nothing
    std::vector<double> lens_px;  ///< fx, fy, cx, cy at width_px x height_px
    std::vector<double> distortion;  ///< k1, k2, p1, p2, k3: Brown's, as OpenCV orders them
    std::vector<double> fisheye;     ///< k1 to k4 of OpenCV's fisheye, in distortion's place
    double latency_ms = 10.0;        ///< from the middle of an exposure to the kernel's stamp
    int width_px = 640;              ///< the nearest that it offers is taken
    int height_px = 480;
    int rate_hz = 30;
};

/// Walks measured settings so that frames fit a VSync (rig/governor). Without settings it is off.
struct GovernorSettings {
    std::string front;      ///< a sweep's pareto.json: its front
    std::string settings;   ///< "MS: KEY = VALUE, ...; MS: ...": instead of a file
    double headroom = 0.1;  ///< share of the VSync that is kept free
    int patience_frames =
        40;  ///< in a row, with room for the next dearer setting, before it is taken
};

inline constexpr std::int64_t kDefaultFrames = 90;

struct Scenario {
    std::string scene = "atrium";
    double scene_scale = 1.0;     ///< metres per unit of the file
    double scene_detail = 1.0;    ///< triangle count of a built-in scene, relative
    std::string devices = "sim";  ///< or hardware, or replay:FILE
    std::string clock = "lockstep";
    std::string cost = "measured";
    std::int64_t frames = 0;  ///< 0: until `seconds`; both 0: kDefaultFrames
    double seconds = 0.0;     ///< of the run's clock; 0: until `frames`
    double settle_s = 0.5;    ///< devices run this long before the first frame
    RecordingSettings recording;
    HardwareSettings hardware;
    TrackingSettings tracking;
    ReplaySettings replay;
    DisplaySettings display;
    WindowSettings window;
    CameraSettings camera;
    LightSettings lights;
    MotionSettings motion;
    ImageSettings images;
    FaultSettings faults;
    GovernorSettings governor;
    RenderSettings render;
    SeeThroughSettings see_through;
};

/// The file that the devices are replayed from; empty: they are not.
inline std::string replayed_file(const Scenario& scenario) {
    constexpr std::string_view kPrefix = "replay:";
    return scenario.devices.starts_with(kPrefix) ? scenario.devices.substr(kPrefix.size()) : "";
}

/// Of the wall clock: a recording may be replayed faster or slower, other devices cannot be.
inline double replay_speed(const Scenario& scenario) {
    return replayed_file(scenario).empty() ? 1.0 : scenario.replay.speed;
}

}  // namespace foverig
