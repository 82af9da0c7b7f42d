#include "rig/session/session.h"

#include <algorithm>
#include <cmath>

#include "rig/identity/processor_use.h"
#include "rig/records/motion_phase.h"
#include "rig/session/angles.h"

namespace foverig {
namespace {

constexpr Nanoseconds kReadbackTail{60'000'000};  // read-backs come one or two VSyncs late

/// A DK2 reports each millisecond: so many lost ones are a cable, not chance, and a prediction over
/// them is a guess.
constexpr Nanoseconds kPoseLimit{100'000'000};

constexpr Nanoseconds kTurnSpan{2'000'000};  // over which the true head's speed is taken

constexpr std::array<Eye, 2> kEyes{Eye::left, Eye::right};

std::size_t eye_count(const Scenario& scenario) {
    return static_cast<std::size_t>(scenario.display.eyes);
}

HostTime mean_of(HostTime a, HostTime b) {
    return a + (b - a) / 2;
}

}  // namespace

Session::Session(const Scenario& scenario, const Scene& scene, Renderer& renderer, LensPass* lens,
                 SessionRecording* recording, const LiveParts* live)
    : scenario_(scenario),
      renderer_(renderer),
      lens_(lens),
      clock_(scenario.clock, parse_cost(scenario.cost).value_or(Cost{}), replay_speed(scenario)),
      recording_(recording),
      world_(make_world(scenario, clock_.clock(), live)),
      devices_(scenario, *world_, clock_.clock(), recording,
               live == nullptr ? DeviceStreams::SeesThrough::no
                               : DeviceStreams::SeesThrough::where_asked),
      flight_(scenario.camera, scene),
      views_(scenario.display),
      pacing_(scenario.display.pacing, world_->display()) {}

RunRecord Session::run(const SessionHooks& hooks) {
    devices_.tell(hooks.notice);
    devices_.run_for(from_seconds(scenario_.settle_s));
    start_ = clock_.now();
    bool interrupted = false;
    while (share_done(frames_.size()) < 1.0 && !world_->at_end()) {
        if (hooks.stop_requested()) {
            // A run without an end is meant to be ended so.
            interrupted = scenario_.frames > 0 || scenario_.seconds > 0.0;
            break;
        }
        FrameRecord frame;
        frame.frame = static_cast<std::uint32_t>(frames_.size());
        frame.wake_up = pacing_.wake_up(clock_.now());
        clock_.clock().sleep_until(frame.wake_up);
        clock_.start_work();
        frame.begin = clock_.now();
        const auto cpu_began = process_time();
        frame.aimed_vsync = pacing_.aimed_vsync(frame.begin);
        const HostTime expected_vsync = pacing_.expected_vsync(frame.begin);
        hooks.frame_begins(frame.begin);
        read_devices(frame.begin);
        FrameInput input = input_for(frame, expected_vsync);
        if (const auto ms = hooks.fixed_ms()) clock_.set_fixed_ms(*ms);
        render_frame(frame, input);
        present(frame, draw(frame, expected_vsync));
        frame.cpu_ms = to_ms(process_time() - cpu_began);
        judge(frame, input);
        frames_.push_back(std::move(frame));
        FrameRecord& done = frames_.back();
        const double share = share_done(frames_.size());
        done.image_kept = hooks.frame_done(done, input, share);
        if (recording_ != nullptr) recording_->frames(frames_, false);
        hooks.progress({frames_.size(), std::min(share, 1.0), to_ms(done.present - done.begin)});
    }
    return finish(interrupted);
}

void Session::read_devices(HostTime deadline) {
    devices_.read_until(deadline);
    match_readbacks();
}

FrameInput Session::input_for(FrameRecord& frame, HostTime expected_vsync) {
    const PanelTiming& timing = world_->display().timing();
    frame.pose = devices_.head().newest();
    frame.gaze = devices_.gaze().newest();
    frame.pose_stale = !frame.pose || frame.begin - frame.pose->taken > kPoseLimit;
    const auto eyes = eye_count(scenario_);
    const HostTime first = timing.photon(expected_vsync, kEyes.front());
    frame.predicted_photon = mean_of(first, timing.photon(expected_vsync, kEyes[eyes - 1]));

    FrameInput input;
    input.frame = frame.frame;
    input.time_s = to_seconds(frame.predicted_photon - start_);
    const Stand stand = flight_.at(input.time_s);
    for (std::size_t i = 0; i < eyes; ++i) {
        const HostTime photon = timing.photon(expected_vsync, kEyes[i]);
        poses_[i] = devices_.head().predict(photon);
        const FilteredGaze gaze = devices_.gaze().at(photon);
        const FilteredEye& eye = kEyes[i] == Eye::left ? gaze.left : gaze.right;
        input.eyes.push_back(views_.eye(kEyes[i], stand, poses_[i], eye.direction));
        frame.gaze_held |= eye.held;
        frame.gaze_stale |= !eye.usable;
        frame.saccade |= eye.saccade;
        frame.gaze_direction[i] = input.eyes[i].gaze;
    }
    const Pose middle = devices_.head().predict(frame.predicted_photon);
    frame.world_from_head = middle.world_from_head;
    frame.head_position_m = stand.position_m + stand.world_from_body * middle.position_m;
    return input;
}

void Session::render_frame(FrameRecord& frame, FrameInput& input) {
    FrameStats stats = renderer_.render(input);
    clock_.end_work(1.0);
    frame.submit = clock_.now();
    frame.render_ms = stats.render_ms;
    frame.passes = std::move(stats.passes);
    frame.rays = stats.rays;
    frame.sampled_pixels = stats.sampled_pixels;
    frame.all_pixels = stats.all_pixels;
    frame.numerics = stats.numerics;
    if (lens_ == nullptr) return;
    for (PassTime& pass : lens_->run(renderer_)) frame.passes.push_back(std::move(pass));
}

EyePicture Session::picture_of(int eye) const {
    return {scenario_.display.eye_width_px, scenario_.display.eye_height_px,
            [this, eye] {
                const View<const Half4> pixels = renderer_.pixels(eye);
                return std::as_bytes(std::span(pixels.data, pixels.size));
            },
            [this, eye](unsigned int texture) { return renderer_.copy_to_texture(eye, texture); }};
}

HostTime Session::draw(FrameRecord& frame, HostTime expected_vsync) {
    Display& display = world_->display();
    if (!display.draws_pictures()) return expected_vsync;
    HostTime pictured_vsync = expected_vsync;
    FramePictures pictures;
    pictures.eyes = eye_count(scenario_);
    for (std::size_t i = 0; i < pictures.eyes; ++i) {
        pictures.pictures[i] = picture_of(static_cast<int>(i));
        pictures.world_from_head[i] = poses_[i].world_from_head;
    }
    if (scenario_.window.late_warp)
        pictures.newest = [&] {
            pictured_vsync = warp_to_newest(frame, expected_vsync);
            return std::array{poses_[0].world_from_head, poses_[1].world_from_head};
        };
    if (devices_.see_through() != nullptr) see_through(frame, pictures);
    const DrawTimes times = display.draw(pictures);
    frame.passes.push_back({"window_upload", to_ms(times.upload)});
    frame.passes.push_back({"window_lens", to_ms(times.lens)});
    return pictured_vsync;
}

void Session::see_through(FrameRecord& frame, FramePictures& pictures) {
    const WallClock stopwatch;
    SeeThrough& camera = *devices_.see_through();
    camera.read_until(clock_.now());
    pictures.behind = camera.picture(devices_.head());
    if (pictures.behind) frame.see_through = camera.instants();
    frame.passes.push_back({"see_through", to_ms(stopwatch.now().time_since_epoch())});
}

HostTime Session::warp_to_newest(FrameRecord& frame, HostTime expected_vsync) {
    devices_.read_until(clock_.now());
    frame.warp = devices_.head().newest();
    const Display& display = world_->display();
    const HostTime vsync = std::max(expected_vsync, display.next_vsync(clock_.now()));
    for (std::size_t i = 0; i < eye_count(scenario_); ++i)
        poses_[i] = devices_.head().predict(display.timing().photon(vsync, kEyes[i]));
    return vsync;
}

void Session::present(FrameRecord& frame, HostTime pictured_vsync) {
    clock_.end_work(0.0);  // a fixed cost is the whole frame's: none is left for the distortion
    frame.present = clock_.now();
    FrameOnPanel on_panel{.frame_id = frame.frame};
    if (frame.pose) {
        on_panel.latency_level = latency_tester_.mark({.frame_id = frame.frame,
                                                       .imu_sample = frame.pose->taken,
                                                       .submit = frame.present,
                                                       .predicted_scan_out = pictured_vsync});
    }
    show(frame, world_->display().present(on_panel, frame.present), pictured_vsync);
    pacing_.frame_done(frame.begin, frame.present);
}

void Session::show(FrameRecord& frame, const Presentation& shown, HostTime pictured_vsync) {
    if (shown.replaced && !frames_.empty()) frames_.back().drop();
    const PanelTiming& timing = world_->display().timing();
    frame.shown_vsync = shown.vsync_number;
    frame.vsync = shown.vsync;
    // Half a period, as a window's VSyncs are no exact grid.
    const double periods = to_seconds(shown.vsync - pictured_vsync) * timing.refresh_hz;
    frame.mis_presented = std::abs(periods) > 0.5;
    const auto eyes = eye_count(scenario_);
    for (std::size_t i = 0; i < eyes; ++i) {
        frame.photon_eye[i] = timing.photon(shown.vsync, kEyes[i]);
    }
    frame.photon = mean_of(*frame.photon_eye[0], *frame.photon_eye[eyes - 1]);
    const auto before = std::find_if(frames_.rbegin(), frames_.rend(),
                                     [](const FrameRecord& f) { return !f.dropped(); });
    if (before != frames_.rend()) {
        frame.missed_vsyncs =
            static_cast<std::uint32_t>(shown.vsync_number - *before->shown_vsync - 1);
    }
}

void Session::judge(FrameRecord& frame, const FrameInput& input) const {
    for (std::size_t i = 0; i < input.eyes.size(); ++i)
        if (const auto known = world_->best_known_gaze(*frame.photon_eye[i]))
            frame.best_known_gaze[i] = vec3((*known)[i]);
    double error_deg = 0.0;
    for (std::size_t i = 0; i < input.eyes.size(); ++i) {
        const auto truth = world_->true_head(*frame.photon_eye[i]);
        if (!truth) return;
        error_deg += angle_deg(poses_[i].world_from_head, *truth);
    }
    frame.prediction_error_deg = error_deg / static_cast<double>(input.eyes.size());
    judge_turn(frame);
    const auto true_gaze = world_->true_gaze(*frame.photon_eye[0]);
    if (true_gaze) frame.gaze_error_deg = angle_deg(dvec3(input.eyes[0].gaze), (*true_gaze)[0]);
}

/// By the first eye's photon, as the head turns there.
void Session::judge_turn(FrameRecord& frame) const {
    const HostTime photon = *frame.photon_eye[0];
    const auto truth = world_->true_head(photon);
    const auto before = world_->true_head(photon - kTurnSpan / 2);
    const auto after = world_->true_head(photon + kTurnSpan / 2);
    const dvec3 speed_rad_s =
        rotation_vector(*after * glm::conjugate(*before)) / to_seconds(kTurnSpan);
    frame.true_head_speed_deg_s = degrees(glm::length(speed_rad_s));
    if (*frame.true_head_speed_deg_s < kHeadMoves_deg_s) return;
    const dvec3 error_rad = rotation_vector(poses_[0].world_from_head * glm::conjugate(*truth));
    frame.head_lag_ms =
        -1e3 * glm::dot(error_rad, speed_rad_s) / glm::dot(speed_rad_s, speed_rad_s);
}

void Session::match_readbacks() {
    const auto readbacks = devices_.head().take_panel_readbacks();
    if (!world_->reads_back_our_frames()) return;
    for (const auto& readback : readbacks) {
        for (const LatencyReading& reading :
             latency_tester_.read_back(readback.frame_count, readback.vsync, readback.grey)) {
            if (reading.frame_id >= frames_.size()) continue;
            FrameRecord& frame = frames_[reading.frame_id];
            if (frame.pose && !frame.dropped()) {
                frame.readback_scan_out = frame.pose->taken + reading.motion_to_scan_out;
            }
        }
    }
}

double Session::share_done(std::uint64_t frames) const {
    double share = 0.0;
    if (scenario_.frames > 0) {
        share = static_cast<double>(frames) / static_cast<double>(scenario_.frames);
    }
    if (scenario_.seconds > 0.0) {
        share = std::max(share, to_seconds(clock_.now() - start_) / scenario_.seconds);
    }
    return share;
}

RunRecord Session::finish(bool interrupted) {
    clock_.clock().sleep_until(clock_.now() + kReadbackTail);
    read_devices(clock_.now());
    RunRecord run;
    if (recording_ != nullptr) {
        recording_->frames(frames_, true);
        run.recording = recording_->end();
    }
    run.frames = std::move(frames_);
    run.devices = devices_.records();
    run.plan = renderer_.plan().effects();
    run.pipeline = scenario_.render.pipeline;
    run.backend = renderer_.backend_name();
    run.backend_bytes = renderer_.backend_bytes();
    run.rate_hz = world_->display().timing().refresh_hz;
    run.fixed_cost = clock_.fixed_cost();
    run.interrupted = interrupted;
    const Display& display = world_->display();
    if (display.draws_pictures()) {
        const VsyncKnowledge known = display.vsync_knowledge();
        run.display =
            DisplayRecord{.vsync_measured = known.source == VsyncKnowledge::Source::display,
                          .vsync_error_ms = to_ms(known.error)};
    }
    return run;
}

}  // namespace foverig
