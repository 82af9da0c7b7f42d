#include "rig/records/columns.h"

#include <algorithm>

namespace foverig {
namespace {

std::int64_t ns(HostTime t) {
    return t.time_since_epoch().count();
}

Cell ns(const std::optional<HostTime>& t) {
    return t ? Cell(ns(*t)) : Cell();
}

Cell cell(const std::optional<double>& value) {
    return value ? Cell(*value) : Cell();
}

Cell count(std::uint64_t n) {
    return static_cast<std::int64_t>(n);
}

std::optional<double> ms_between(const std::optional<HostTime>& from,
                                 const std::optional<HostTime>& to) {
    if (!from || !to) return std::nullopt;
    return to_ms(*to - *from);
}

std::optional<HostTime> taken(const std::optional<SampleInstants>& sample) {
    return sample ? std::optional(sample->taken) : std::nullopt;
}

std::optional<HostTime> arrived(const std::optional<SampleInstants>& sample) {
    return sample ? std::optional(sample->arrived) : std::nullopt;
}

std::vector<Column> instants() {
    using F = const FrameRecord&;
    return {
        {"frame", "", "number of the frame, from 0", [](F f) { return count(f.frame); }},
        {"wake_up_ns", "ns", "pacing let the frame start", [](F f) { return Cell(ns(f.wake_up)); }},
        {"begin_ns", "ns", "devices are read from here", [](F f) { return Cell(ns(f.begin)); }},
        {"sample_ns", "ns", "newest inertial sample behind the pose, device time on the host clock",
         [](F f) { return ns(taken(f.pose)); }},
        {"sample_arrival_ns", "ns", "arrival of that sample's report",
         [](F f) { return ns(arrived(f.pose)); }},
        {"gaze_ns", "ns", "newest valid gaze sample (mid-exposure), on the host clock",
         [](F f) { return ns(taken(f.gaze)); }},
        {"gaze_arrival_ns", "ns", "arrival of that gaze sample",
         [](F f) { return ns(arrived(f.gaze)); }},
        {"warp_sample_ns", "ns",
         "newest inertial sample behind the late warp of a window's picture",
         [](F f) { return ns(taken(f.warp)); }},
        {"see_through_ns", "ns",
         "middle of the exposure of the camera frame behind a window's picture, by "
         "see_through.latency_ms",
         [](F f) { return ns(taken(f.see_through)); }},
        {"submit_ns", "ns", "images of all eyes are rendered",
         [](F f) { return Cell(ns(f.submit)); }},
        {"present_ns", "ns", "distorted and handed to the display",
         [](F f) { return Cell(ns(f.present)); }},
        {"aimed_vsync_ns", "ns", "the first VSync after begin",
         [](F f) { return Cell(ns(f.aimed_vsync)); }},
        {"vsync_ns", "ns", "the VSync whose scan-out shows the frame first",
         [](F f) { return ns(f.vsync); }},
        {"photon_ns", "ns", "mean of the eyes' photons", [](F f) { return ns(f.photon); }},
        {"photon_left_ns", "ns", "mid-persistence at the centre of the left eye's half",
         [](F f) { return ns(f.photon_eye[0]); }},
        {"photon_right_ns", "ns", "the same for the right eye",
         [](F f) { return ns(f.photon_eye[1]); }},
        {"predicted_photon_ns", "ns", "the instant that pose and gaze were predicted to",
         [](F f) { return Cell(ns(f.predicted_photon)); }},
    };
}

std::vector<Column> times_and_counts() {
    using F = const FrameRecord&;
    return {
        {"frame_time_ms", "ms", "begin to present: work, without waiting for the display",
         [](F f) { return Cell(frame_time_ms(f)); }},
        {"motion_to_photon_ms", "ms", "sample to photon",
         [](F f) { return cell(motion_to_photon_ms(f)); }},
        {"gaze_to_photon_ms", "ms", "gaze to photon",
         [](F f) { return cell(gaze_to_photon_ms(f)); }},
        {"warp_to_photon_ms", "ms", "sample behind the late warp to photon",
         [](F f) { return cell(warp_to_photon_ms(f)); }},
        {"see_through_to_photon_ms", "ms", "camera frame's exposure to photon: its age",
         [](F f) { return cell(see_through_to_photon_ms(f)); }},
        {"imu_transport_ms", "ms",
         "sample to its arrival, beyond the smallest such delay, which no clock map can see",
         [](F f) { return cell(imu_transport_ms(f)); }},
        {"gaze_transport_ms", "ms", "gaze to its arrival",
         [](F f) { return cell(gaze_transport_ms(f)); }},
        {"motion_to_photon_readback_ms", "ms",
         "sample to start of scan-out, by the panel's read-back",
         [](F f) { return cell(readback_ms(f)); }},
        {"prediction_error_deg", "deg", "predicted head pose against the true one at the photon",
         [](F f) { return cell(f.prediction_error_deg); }},
        {"gaze_error_deg", "deg", "gaze used against the true one at the photon, left eye",
         [](F f) { return cell(f.gaze_error_deg); }},
        {"true_head_speed_deg_s", "deg/s", "how fast the head turns at the photon",
         [](F f) { return cell(f.true_head_speed_deg_s); }},
        {"head_lag_ms", "ms",
         "how long ago the head faced as shown; below 0: prediction went too far",
         [](F f) { return cell(f.head_lag_ms); }},
        {"missed_vsyncs", "", "VSyncs just before this frame's that repeated an older one",
         [](F f) { return count(f.missed_vsyncs); }},
        {"late", "", "1: missed the VSync that it was begun for",
         [](F f) { return count(f.late()); }},
        {"mis_presented", "",
         "1: shown at another VSync than its picture is of, be it later or earlier: the one that "
         "its head pose was predicted for or, where there is a late warp (warp_sample_ns), that "
         "the warp turned it to; the gaze is always of the former",
         [](F f) { return count(f.mis_presented); }},
        {"dropped", "", "1: replaced before any VSync showed it",
         [](F f) { return count(f.dropped()); }},
        {"rays_primary", "", "primary rays", [](F f) { return count(f.rays.primary); }},
        {"rays_shadow", "", "shadow rays", [](F f) { return count(f.rays.shadow); }},
        {"rays_ao", "", "ambient occlusion rays", [](F f) { return count(f.rays.ao); }},
        {"rays_reflection", "", "reflection rays", [](F f) { return count(f.rays.reflection); }},
        {"rays_probe", "", "probe rays", [](F f) { return count(f.rays.probe); }},
        {"rays_vpl", "", "rays of virtual point lights", [](F f) { return count(f.rays.vpl); }},
        {"sampled_pixels", "px", "pixels that got a primary ray",
         [](F f) { return count(f.sampled_pixels); }},
        {"all_pixels", "px", "pixels of all eyes", [](F f) { return count(f.all_pixels); }},
        {"nan", "", "NaNs that kernels met", [](F f) { return count(f.numerics.nan); }},
        {"inf", "", "infinities that kernels met", [](F f) { return count(f.numerics.inf); }},
        {"clamped", "", "values that kernels clamped",
         [](F f) { return count(f.numerics.clamped); }},
        {"pose_stale", "", "1: no inertial sample for 0.1 s: the last head pose stands",
         [](F f) { return count(f.pose_stale); }},
        {"gaze_held", "", "1: the newest gaze sample had nothing for an eye (blink, loss)",
         [](F f) { return count(f.gaze_held); }},
        {"gaze_stale", "", "1: nothing for 0.5 s: the last gaze stands, wherever the eye is",
         [](F f) { return count(f.gaze_stale); }},
        {"saccade", "", "1: an eye was in a saccade", [](F f) { return count(f.saccade); }},
        {"governor_setting", "",
         "which of the governor's settings, the cheapest 0; NA: no governor",
         [](F f) { return f.governor_setting ? count(*f.governor_setting) : Cell(); }},
        {"image_kept", "", "1: images of this frame are in images/",
         [](F f) { return count(f.image_kept); }},
    };
}

std::vector<Column> poses() {
    using F = const FrameRecord&;
    return {
        {"head_qw", "", "predicted head pose, tracking frame",
         [](F f) { return Cell(f.world_from_head.w); }},
        {"head_qx", "", "", [](F f) { return Cell(f.world_from_head.x); }},
        {"head_qy", "", "", [](F f) { return Cell(f.world_from_head.y); }},
        {"head_qz", "", "", [](F f) { return Cell(f.world_from_head.z); }},
        {"head_x_m", "m", "point between the eyes, in the scene",
         [](F f) { return Cell(f.head_position_m.x); }},
        {"head_y_m", "m", "", [](F f) { return Cell(f.head_position_m.y); }},
        {"head_z_m", "m", "", [](F f) { return Cell(f.head_position_m.z); }},
        {"gaze_left_x", "", "unit gaze of the left eye, eye frame (x right, y up, -z ahead)",
         [](F f) { return Cell(static_cast<double>(f.gaze_direction[0].x)); }},
        {"gaze_left_y", "", "",
         [](F f) { return Cell(static_cast<double>(f.gaze_direction[0].y)); }},
        {"gaze_right_x", "", "the same of the right eye",
         [](F f) { return Cell(static_cast<double>(f.gaze_direction[1].x)); }},
        {"gaze_right_y", "", "",
         [](F f) { return Cell(static_cast<double>(f.gaze_direction[1].y)); }},
    };
}

}  // namespace

double frame_time_ms(const FrameRecord& f) {
    return to_ms(f.present - f.begin);
}

std::optional<double> motion_to_photon_ms(const FrameRecord& f) {
    return ms_between(taken(f.pose), f.photon);
}
std::optional<double> gaze_to_photon_ms(const FrameRecord& f) {
    return ms_between(taken(f.gaze), f.photon);
}
std::optional<double> warp_to_photon_ms(const FrameRecord& f) {
    return ms_between(taken(f.warp), f.photon);
}
std::optional<double> see_through_to_photon_ms(const FrameRecord& f) {
    return ms_between(taken(f.see_through), f.photon);
}
std::optional<double> imu_transport_ms(const FrameRecord& f) {
    return ms_between(taken(f.pose), arrived(f.pose));
}
std::optional<double> gaze_transport_ms(const FrameRecord& f) {
    return ms_between(taken(f.gaze), arrived(f.gaze));
}
std::optional<double> readback_ms(const FrameRecord& f) {
    return ms_between(taken(f.pose), f.readback_scan_out);
}

const std::vector<Column>& frame_columns() {
    static const std::vector<Column> columns = [] {
        std::vector<Column> all = instants();
        for (auto& column : times_and_counts()) all.push_back(std::move(column));
        for (auto& column : poses()) all.push_back(std::move(column));
        return all;
    }();
    return columns;
}

std::vector<Column> wall_columns(const std::vector<FrameRecord>& frames) {
    std::vector<std::string> names;
    for (const FrameRecord& frame : frames) {
        for (const PassTime& pass : frame.passes) {
            if (std::find(names.begin(), names.end(), pass.name) == names.end()) {
                names.push_back(pass.name);
            }
        }
    }
    std::vector<Column> columns{
        {"render_ms", "ms", "wall time inside the renderer",
         [](const FrameRecord& frame) { return Cell(frame.render_ms); }},
        {"cpu_ms", "ms",
         "processor time of all threads, begin to present; what other programs, or other guests of "
         "the machine's host, had meanwhile is not in it",
         [](const FrameRecord& frame) { return Cell(frame.cpu_ms); }}};
    for (const std::string& name : names) {
        columns.push_back({"pass." + name + "_ms", "ms", "share of the frame's wall time",
                           [name](const FrameRecord& frame) {
                               for (const PassTime& pass : frame.passes) {
                                   if (pass.name == name) return Cell(pass.ms);
                               }
                               return Cell();
                           }});
    }
    return columns;
}

}  // namespace foverig
