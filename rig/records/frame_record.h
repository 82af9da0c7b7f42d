#pragma once
// All that is known of one frame: every instant, every pass, every count. Reports are computed
// from these alone. What was not measured is absent, never 0.
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "devices/time.h"
#include "renderer/renderer.h"
#include "renderer/vec.h"

namespace foverig {

/// When a sample was taken (device time mapped to the host) and when its bytes arrived.
struct SampleInstants {
    HostTime taken{};
    HostTime arrived{};
};

struct FrameRecord {
    std::uint32_t frame = 0;

    HostTime wake_up{};                  ///< pacing let the frame start
    HostTime begin{};                    ///< devices are read from here
    std::optional<SampleInstants> pose;  ///< newest inertial sample behind the head pose
    std::optional<SampleInstants> gaze;  ///< newest valid gaze sample
    std::optional<SampleInstants> warp;  ///< ... behind the late warp; absent: there was none
    std::optional<SampleInstants> see_through;          ///< camera frame behind a window's picture
    HostTime submit{};                                  ///< images of all eyes are done
    HostTime present{};                                 ///< handed to the display, distorted
    std::optional<HostTime> vsync;                      ///< scan-out begins; absent: dropped
    std::array<std::optional<HostTime>, 2> photon_eye;  ///< mid-persistence at each eye's centre
    std::optional<HostTime> photon;                     ///< mean of the eyes' photons
    HostTime predicted_photon{};                        ///< what the pose was predicted to
    std::optional<HostTime> readback_scan_out;  ///< as the panel's pixel read-back tells (1.7)

    HostTime aimed_vsync{};                    ///< the first VSync after its begin
    std::optional<std::uint64_t> shown_vsync;  ///< number of the VSync that showed it first
    bool mis_presented = false;                ///< ... is another than the picture is of
    std::uint32_t missed_vsyncs = 0;  ///< repeats of the frame before, just before this one

    double render_ms = 0.0;        ///< wall time in the renderer, whatever the clock
    double cpu_ms = 0.0;           ///< processor time of all threads, begin to present
    std::vector<PassTime> passes;  ///< shares of it
    RayCounts rays;
    std::uint64_t sampled_pixels = 0;
    std::uint64_t all_pixels = 0;
    NumericCounts numerics;

    dquat world_from_head{1.0, 0.0, 0.0, 0.0};  ///< predicted, tracking frame
    dvec3 head_position_m{0.0};                 ///< in the scene, between the eyes
    std::array<vec3, 2> gaze_direction{vec3(0.0F, 0.0F, -1.0F), vec3(0.0F, 0.0F, -1.0F)};
    std::optional<double> prediction_error_deg;  ///< of the head's pose at the photon; needs truth
    std::optional<double> gaze_error_deg;        ///< of the gaze used, at the photon; needs truth
    /// Where each eye really looked at its photon, head frame; in a replay: as recorded.
    std::array<std::optional<vec3>, 2> best_known_gaze;
    std::optional<double> true_head_speed_deg_s;  ///< at the photon; needs truth
    /// How long ago the head faced as the frame showed it: the error along the turn over its speed,
    /// below 0 where prediction went too far; absent where the head hardly turns. Needs truth.
    std::optional<double> head_lag_ms;
    bool pose_stale = false;  ///< the newest inertial sample is too old to predict from
    bool gaze_held =
        false;  ///< the newest gaze sample had nothing for an eye: its last gaze stands
    bool gaze_stale = false;  ///< ... and that is older than GazeFilterConfig::hold_limit
    bool saccade = false;     ///< an eye was in a saccade
    std::optional<std::uint32_t> governor_setting;  ///< which of the governor's, cheapest 0
    bool image_kept = false;                        ///< work for images followed this frame

    bool dropped() const { return !shown_vsync.has_value(); }
    bool late() const { return !vsync || *vsync > aimed_vsync; }

    /// A later frame came before any VSync showed this one: what it would have shown is void.
    void drop() {
        shown_vsync.reset();
        vsync.reset();
        photon_eye = {};
        photon.reset();
        missed_vsyncs = 0;
        mis_presented = false;
        prediction_error_deg.reset();
        gaze_error_deg.reset();
        best_known_gaze = {};
        true_head_speed_deg_s.reset();
        head_lag_ms.reset();
    }
};

}  // namespace foverig
