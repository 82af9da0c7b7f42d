// The recorder under the whole rig's load in real time: IMU at 1 kHz, camera at 60 frames a second,
// gaze at 250 Hz, frames at 75 Hz, on a disk that stands for half a second now and then; plain and
// packed.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <thread>

#include "bench/suites.h"
#include "devices/camera/frame.h"
#include "devices/dk2/input_reports.h"
#include "devices/dk2/leds.h"
#include "devices/gaze/frames.h"
#include "devices/recording/file_sink.h"
#include "devices/recording/file_source.h"
#include "devices/recording/recorder.h"
#include "devices/recording/recover.h"
#include "devices/recording/sample_json.h"
#include "rig/records/frame_json.h"
#include "simulators/camera/simulated_camera.h"
#include "simulators/dk2/simulated_dk2.h"
#include "simulators/motion/catalog.h"

namespace foverig::bench {
namespace {

constexpr int kSeconds = 10;
constexpr int kImages = 8;
constexpr std::uint64_t kRaw = 1000 + 60 + 250, kDecoded = 1000 + 250 + 75;

/// A file on a disk that stands for `stall` before the first write of every `period` bytes.
class StallingSink final : public ByteSink {
  public:
    StallingSink(FileSink file, Nanoseconds stall, std::uint64_t period_bytes)
        : file_(std::move(file)), stall_(stall), period_bytes_(period_bytes) {}
    Status write(Bytes bytes) override {
        if (written_ >= next_stall_) {
            std::this_thread::sleep_for(stall_);
            next_stall_ += period_bytes_;
        }
        written_ += bytes.size();
        return file_.write(bytes);
    }
    Status close() override { return file_.close(); }

  private:
    FileSink file_;
    Nanoseconds stall_;
    std::uint64_t period_bytes_, written_ = 0, next_stall_ = 0;
};

double cpu_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// What the tracker camera sees of a headset, each time with other noise: packing gains what it
/// gains on a desk.
std::vector<std::vector<std::byte>> camera_images() {
    ManualClock clock;
    const auto still = std::move(motion::make_head("still", 1)).value();
    SimulatedDk2 headset(clock, *still);
    const motion::HeadState head = still->at(0.0);
    const RigidPose world_from_imu{head.world_from_head,
                                   head.position_m + head.world_from_head * kImuFromEyes_m};
    const RigidPose camera_from_imu = usual_camera_place().inverse() * world_from_imu;
    std::vector<std::vector<std::byte>> images;
    for (int i = 0; i < kImages; ++i) {
        CameraScene scene(dk2::read_leds(headset).value(), camera::Lens{}, {.noise = 1},
                          static_cast<std::uint64_t>(i));
        std::vector<std::byte> image(static_cast<std::size_t>(kCameraWidth_px) * kCameraHeight_px);
        scene.render({.camera_from_imu = camera_from_imu, .pattern = 3}, image);
        images.push_back(camera::encode_frame({}, image));
    }
    return images;
}

/// What a rig with every device records in one millisecond.
class Load {
  public:
    explicit Load(Recorder& recorder)
        : recorder_(recorder),
          imu_raw_(recorder.add_topic({.topic = "/dk2/raw", .message_encoding = "x-hid"})),
          gaze_raw_(recorder.add_topic({.topic = "/gaze/raw", .message_encoding = "x-sgz1"})),
          camera_(recorder.add_topic({.topic = "/camera/raw", .message_encoding = "x-fcf1"})),
          imu_(recorder.add_topic(imu_topic())),
          gaze_(recorder.add_topic(gaze_topic())),
          frames_(recorder.add_topic({.topic = "/frames",
                                      .message_encoding = "json",
                                      .schema_name = "foverig.FrameRecord",
                                      .json_schema = frame_json_schema()})) {}

    void step(int ms) {
        const HostTime now(Nanoseconds(std::int64_t{ms} * 1'000'000));
        take_imu(now);
        if (ms % 4 == 0) take_gaze(now);
        if (ms * 60 / 1000 != (ms + 1) * 60 / 1000)
            recorder_.record(camera_, now, now, images_[++image_ % images_.size()]);
        if (ms * 75 / 1000 != (ms + 1) * 75 / 1000) {
            frame_.begin = frame_.submit = frame_.present = now;
            ++frame_.frame;
            record_text(frames_, now, frame_json(frame_));
        }
    }

  private:
    void take_imu(HostTime now) {
        report_.sample_timestamp_us += 1000;
        const auto bytes = report_.encode();
        recorder_.record(imu_raw_, now, now, bytes);
        sample_.host_time = sample_.arrival = now;
        sample_.gyro_rad_s = {0.123456789, -0.2, 0.3};
        sample_.accel_m_s2 = {0.1, 9.80665, -0.0123456};
        write_json(text_, sample_);
        record_text(imu_, now, text_);
    }
    void take_gaze(HostTime now) {
        ++gaze_frame_.header.sequence;
        const auto bytes = gaze_frame_.encode();
        recorder_.record(gaze_raw_, now, now, bytes);
        write_json(text_, to_sample(gaze_frame_));
        record_text(gaze_, now, text_);
    }
    void record_text(Recorder::TopicId topic, HostTime now, const std::string& text) {
        recorder_.record(topic, now, now, std::as_bytes(std::span(text)));
    }

    Recorder& recorder_;
    Recorder::TopicId imu_raw_, gaze_raw_, camera_, imu_, gaze_, frames_;
    std::vector<std::vector<std::byte>> images_ = camera_images();
    std::size_t image_ = 0;
    dk2::InputReport11 report_;
    ImuSample sample_;
    gaze::SampleFrame gaze_frame_;
    FrameRecord frame_;
    std::string text_;
};

/// Everything of a second, kSeconds times, is in the file and reads back.
bool holds_everything(const std::filesystem::path& file) {
    auto source = FileSource::open(file);
    if (!source) return false;
    const auto opened = mcap::RecordFile::open(
        std::make_unique<FileSource>(std::move(source).value()), file.string());
    return opened && mcap::check_recovered(*opened, {.messages = kSeconds * (kRaw + kDecoded)});
}

struct Setup {
    std::string name;
    Nanoseconds stall;
    mcap::Compression compression;
};

void run(benchmark::State& state, Bench& bench, const Setup& c) {
    const auto file = std::filesystem::temp_directory_path() / "foverig_recorder_bench.mcap";
    for (auto unused : state) {
        auto sink = FileSink::create(file);
        if (!sink) return state.SkipWithError(sink.error().text.c_str());
        auto recorder =
            Recorder::begin(std::make_unique<StallingSink>(std::move(sink).value(), c.stall,
                                                           std::uint64_t{60} << 20),
                            {.compression = c.compression});
        if (!recorder) return state.SkipWithError(recorder.error().text.c_str());
        Load load(**recorder);
        WallClock clock;
        double slowest_ms = 0.0;
        const double cpu_before = cpu_seconds();
        for (int ms = 0; ms < 1000 * kSeconds; ++ms) {
            clock.sleep_until(HostTime(Nanoseconds(std::int64_t{ms} * 1'000'000)));
            const HostTime begin = clock.now();
            load.step(ms);
            slowest_ms = std::max(slowest_ms, to_ms(clock.now() - begin));
        }
        const double share = (cpu_seconds() - cpu_before) / to_seconds(clock.now() - HostTime{});
        if (auto status = (*recorder)->close(); !status)
            return state.SkipWithError(status.error().text.c_str());
        const RecorderCounts counts = (*recorder)->counts();
        if (counts.dropped == 0 && !holds_everything(file))
            return state.SkipWithError("the file does not hold what was recorded");
        const double mb_s = static_cast<double>(counts.bytes) * 1e-6 / kSeconds;
        state.counters["core_share"] = share;
        state.counters["dropped"] = static_cast<double>(counts.dropped);
        state.counters["MB_per_s"] = mb_s;
        state.counters["slowest_step_ms"] = slowest_ms;
        bench.results.add("recorder", c.name,
                          {{"seconds", kSeconds},
                           {"core_share", share},
                           {"messages", counts.messages},
                           {"dropped", counts.dropped},
                           {"mb_per_s", mb_s},
                           {"slowest_step_ms", slowest_ms}});
    }
    std::filesystem::remove(file);
}

}  // namespace

void register_recorder(Bench& bench) {
    const std::vector<Setup> cases{
        {"steady disk", {}, mcap::Compression::none},
        {"disk stalls 500 ms", Nanoseconds(500'000'000), mcap::Compression::none},
        {"steady disk, zstd", {}, mcap::Compression::zstd},
        {"disk stalls 500 ms, zstd", Nanoseconds(500'000'000), mcap::Compression::zstd}};
    for (const Setup& c : cases) {
        benchmark::RegisterBenchmark(("BM_Recorder/" + c.name).c_str(),
                                     [&bench, c](benchmark::State& state) { run(state, bench, c); })
            ->Iterations(1)
            ->UseRealTime()
            ->Unit(benchmark::kMillisecond);
    }
}

}  // namespace foverig::bench
