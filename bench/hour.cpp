// Issue 4, bar 2: an hour of a head and its eyes in lockstep, from the simulated devices' bytes.
// One fusion follows the head by inertial sensor and camera, one by the sensor alone: nothing lost,
// clocks related, nothing drifts.
// (--benchmark_filter=hour/3600: every one of the 216 000 images is rendered and searched.)
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/suites.h"
#include "devices/camera/head_camera.h"
#include "devices/dk2/imu_source.h"
#include "devices/fusion/rotation.h"
#include "devices/fusion/tracked_head.h"
#include "devices/gaze/gaze_source.h"
#include "simulators/camera/simulated_camera.h"
#include "simulators/dk2/simulated_dk2.h"
#include "simulators/gaze/simulated_gaze.h"
#include "simulators/motion/catalog.h"

namespace foverig::bench {
namespace {

constexpr std::uint64_t kSeed = 5;
constexpr Nanoseconds kStep{10'000'000};
constexpr double kSettle_s = 2.0;
constexpr double kLearn_s = 30.0;           // without the camera, for the gyro's bias
constexpr Nanoseconds kPollPhase{100'000};  // the smallest transport delay: no clock map can see it

/// 50 ppm of drift and 1 ms of host delay, on average; bias, its drift with temperature and noise
/// of a chip.
const Dk2Faults kDk2{.noise = 1,
                     .low_pass = 250,
                     .quantise = 1,
                     .bias = 0.2,
                     .temperature_drift = 0.01,
                     .random_walk = 3e-5,
                     .clock_drift = 50,
                     .host_delay = 1.0};

const GazeFaults kGaze{.noise = 0.5, .latency_jitter = 1.0, .clock_drift = 50};
constexpr std::uint16_t kGazeRate_hz = 250;

double p99(std::vector<double>& values) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 99 / 100);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// How far sample times and one fusion's poses were off at worst.
struct Worst {
    double tilt_deg = 0, yaw_deg = 0, mm = 0;

    void judge(const Pose& pose, const motion::HeadState& truth) {
        const dquat error = pose.world_from_head * glm::conjugate(truth.world_from_head);
        const dvec3 up = error * dvec3(0, 1, 0), ahead = error * dvec3(0, 0, -1);
        tilt_deg = std::max(tilt_deg, glm::degrees(std::atan2(std::hypot(up.x, up.z), up.y)));
        yaw_deg = std::max(yaw_deg, std::abs(glm::degrees(std::atan2(-ahead.x, -ahead.z))));
        mm = std::max(mm, 1e3 * glm::distance(pose.position_m, truth.position_m));
    }
};

struct Judged {
    Worst tracked;                        ///< with the camera
    Worst learning, inertial;             ///< without, until kLearn_s and after it
    std::vector<double> imu_us, gaze_us;  ///< of the samples' host times
};

/// Frames come late by 1 ms more, on average, in order. GET_TIME is refused: in lockstep it takes
/// no time, which would relate the clocks for nothing.
class LateGaze final : public Transport {
  public:
    explicit LateGaze(Transport& device) : device_(device) {}

    NextPacket next(HostTime deadline) override {
        while (true) {
            NextPacket next = device_.next(deadline);
            auto* packet = std::get_if<Packet>(&next);
            if (packet == nullptr) break;
            last_ =
                std::max(last_, packet->arrival + from_seconds(delay_.exponential(++index_, 1e-3)));
            packet->arrival = last_;
            late_.push_back(std::move(*packet));
        }
        if (late_.empty() || late_.front().arrival > deadline) return Timeout{};
        return late_.pop_front();
    }
    Status control_set(std::uint8_t id, std::uint16_t value, Bytes data) override {
        return device_.control_set(id, value, data);
    }
    Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t value,
                                               std::size_t size) override {
        if (id == gaze::request::get_time) return Error{ErrorCode::unsupported, "refused"};
        return device_.control_get(id, value, size);
    }

  private:
    Transport& device_;
    motion::Draws delay_{kSeed, 77};
    std::uint64_t index_ = 0;
    HostTime last_{};
    Ring<Packet> late_;
};

class Followed {
  public:
    Followed()
        : head_(std::move(motion::make_head("look", kSeed)).value()),
          dk2_(clock_, *head_, {.faults = kDk2, .seed = kSeed, .poll_phase = kPollPhase}),
          leds_(dk2::read_leds(dk2_).value()),
          device_(clock_, *head_, dk2_, {.leds = leds_, .faults = {.noise = 1}, .seed = kSeed}),
          camera_(camera::HeadCamera::open(device_, leds_).value()),
          imu_(dk2::Dk2ImuSource::open(dk2_, clock_.now(), {.light_leds = true}).value()),
          eyes_(std::move(motion::make_eye("scan", kSeed)).value()),
          tracker_(clock_, *eyes_, {.faults = kGaze, .seed = kSeed}),
          late_tracker_(tracker_),
          gaze_(gaze::GazeSource::open(late_tracker_, clock_, {.rate_hz = kGazeRate_hz}).value()),
          tracked_({.inertial = {.initial_yaw_rad = yaw_of(truth())}}),
          inertial_({.inertial = {.initial_yaw_rad = yaw_of(truth())}}) {}

    void step(Judged& judged) {
        clock_.sleep_until(clock_.now() + kStep);
        const double now_s = to_seconds(clock_.now().time_since_epoch());
        const bool settled = now_s > kSettle_s;
        read_imu(settled ? &judged : nullptr);
        read_gaze(settled ? &judged : nullptr);
        camera_->add(imu_.take_exposures());
        while (true) {
            const auto next =
                camera_->next(clock_.now(), [this](Dk2Time t) { return tracked_.expected(t); });
            const auto* fix = std::get_if<PoseFix>(&next);
            if (fix == nullptr) break;
            tracked_.add(*fix);
        }
        if (!settled) return;
        judged.tracked.judge(tracked_.at(clock_.now()), truth());
        Worst& alone = now_s < kLearn_s ? judged.learning : judged.inertial;
        alone.judge(inertial_.at(clock_.now()), truth());
    }
    SourceCounts imu() const { return imu_.counts(); }
    SourceCounts gaze() const { return gaze_.counts(); }
    std::uint64_t missed_exposures() const { return gaze_.missed_exposures(); }
    SourceCounts camera() const { return camera_->source().counts(); }
    std::uint64_t fixes() const { return tracked_.counts().fixes; }

  private:
    motion::HeadState truth() const {
        return head_->at(to_seconds(clock_.now().time_since_epoch()));
    }
    static double yaw_of(const motion::HeadState& state) {
        const dvec3 ahead = state.world_from_head * dvec3(0, 0, -1);
        return std::atan2(-ahead.x, -ahead.z);
    }
    void read_imu(Judged* judged) {
        while (true) {
            const auto next = imu_.next(clock_.now());
            const auto* sample = std::get_if<ImuSample>(&next);
            if (sample == nullptr) return;
            tracked_.add(*sample);
            inertial_.add(*sample);
            if (judged == nullptr) continue;
            const HostTime taken(static_cast<std::int64_t>(sample->sequence + 1) *
                                 Nanoseconds{1'000'000});
            judged->imu_us.push_back(1e6 *
                                     std::abs(to_seconds(sample->host_time - taken - kPollPhase)));
        }
    }
    /// The tracker was started at 0; the smallest delay is one USB transfer.
    void read_gaze(Judged* judged) {
        while (true) {
            const auto next = gaze_.next(clock_.now());
            const auto* sample = std::get_if<GazeSample>(&next);
            if (sample == nullptr) return;
            if (judged == nullptr) continue;
            const double taken_s =
                sample->camera_frame / (kGazeRate_hz * (1.0 + 1e-6 * kGaze.clock_drift));
            judged->gaze_us.push_back(1e6 *
                                      std::abs(to_seconds(sample->host_time.time_since_epoch() -
                                                          GazeFirmware::kUsbTransfer) -
                                               taken_s));
        }
    }

    ManualClock clock_;
    std::unique_ptr<motion::HeadMotion> head_;
    SimulatedDk2 dk2_;
    std::vector<dk2::Led> leds_;
    SimulatedCamera device_;
    std::unique_ptr<camera::HeadCamera> camera_;
    dk2::Dk2ImuSource imu_;
    std::unique_ptr<motion::EyeMotion> eyes_;
    SimulatedGaze tracker_;
    LateGaze late_tracker_;
    gaze::GazeSource gaze_;
    TrackedHead tracked_, inertial_;
};

void run(benchmark::State& state, Bench& bench) {
    for (auto unused : state) {
        Followed followed;
        Judged judged;
        const std::int64_t seconds = state.range(0);
        for (std::int64_t i = 0; i < seconds * 100; ++i) followed.step(judged);
        const double imu_p99_us = p99(judged.imu_us), gaze_p99_us = p99(judged.gaze_us);
        const auto bad = [](const SourceCounts& c) { return c.lost + c.rejected; };
        const std::uint64_t lost = bad(followed.imu()) + bad(followed.camera()) +
                                   bad(followed.gaze()) + followed.missed_exposures();
        bench.results.add("hour", fmt::format("{} s", seconds),
                          {{"seconds", seconds},
                           {"imu_samples", followed.imu().samples},
                           {"gaze_samples", followed.gaze().samples},
                           {"images", followed.camera().samples},
                           {"fixes", followed.fixes()},
                           {"lost_or_rejected", lost},
                           {"imu_clock_p99_us", imu_p99_us},
                           {"gaze_clock_p99_us", gaze_p99_us},
                           {"tilt_deg", judged.tracked.tilt_deg},
                           {"yaw_deg", judged.tracked.yaw_deg},
                           {"position_mm", judged.tracked.mm},
                           {"tilt_without_camera_deg", judged.inertial.tilt_deg},
                           {"tilt_without_camera_first_30_s_deg", judged.learning.tilt_deg},
                           {"yaw_without_camera_deg", judged.inertial.yaw_deg}});
        state.counters["lost"] = static_cast<double>(lost);
        state.counters["imu_clock_p99_us"] = imu_p99_us;
        state.counters["gaze_clock_p99_us"] = gaze_p99_us;
        state.counters["tilt_deg"] = judged.tracked.tilt_deg;
        state.counters["yaw_deg"] = judged.tracked.yaw_deg;
        state.counters["tilt_without_camera_deg"] = judged.inertial.tilt_deg;
        const bool good = lost == 0 && imu_p99_us < 100 && gaze_p99_us < 100 &&
                          judged.tracked.tilt_deg < 0.5 && judged.tracked.yaw_deg < 0.5 &&
                          judged.inertial.tilt_deg < 0.5;
        if (!good) state.SkipWithError("a bar of issue 4 is not held; the counters say which");
    }
}

}  // namespace

void register_hour(Bench& bench) {
    benchmark::RegisterBenchmark("hour", [&bench](benchmark::State& state) { run(state, bench); })
        ->Arg(60)
        ->Arg(3600)
        ->Unit(benchmark::kSecond)
        ->Iterations(1);
}

}  // namespace foverig::bench
