#include "rig/session/session_recording.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "devices/recording/file_sink.h"
#include "rig/identity/build_info.h"
#include "rig/records/frame_json.h"
#include "rig/scenario/write.h"

namespace foverig {
namespace {

// A later frame may replace one, and a read-back comes one or two VSyncs late.
constexpr std::size_t kFramesThatMayChange = 8;

template <class T>
T or_throw(Result<T> result) {
    if (!result) throw std::runtime_error("recording failed: " + result.error().text);
    return std::move(result).value();
}

mcap::Metadata build_note() {
    const BuildInfo build = build_info();
    return {.name = "foverig.build",
            .texts = {{"version", build.version},
                      {"git", build.git.value_or("")},
                      {"compiler", build.compiler},
                      {"flags", build.flags},
                      {"type", build.build_type},
                      {"fp_mode", build.fp_mode}}};
}

mcap::Attachment text_attachment(const char* name, const char* media_type,
                                 const std::string& text) {
    return {
        .name = name, .media_type = media_type, .data = to_vector(std::as_bytes(std::span(text)))};
}

std::string numbers(const dvec3& v) {
    return fmt::format("{} {} {}", v.x, v.y, v.z);
}

std::string numbers(const dmat3& columns) {
    const dmat3 rows = glm::transpose(columns);
    return fmt::format("{} {} {}", numbers(rows[0]), numbers(rows[1]), numbers(rows[2]));
}

/// Rows of temperature and offset.
std::string numbers(const std::vector<dk2::OffsetAt>& offsets) {
    std::vector<std::string> rows;
    for (const dk2::OffsetAt& offset : offsets) {
        rows.push_back(fmt::format("{} {}", offset.temperature_c, numbers(offset.rad_s)));
    }
    return fmt::format("{}", fmt::join(rows, " "));
}

std::string text_of(const std::optional<Origin>& origin) {
    return origin ? name_of(*origin) : "";
}

RecordedDevice frames_of(const char* camera, const std::optional<Origin>& origin) {
    return {.name = camera,
            .packet_encoding = "x-fcf1",
            .device_time = "u32 LE at byte 20, us: from its time stamp to its arrival",
            .origin = text_of(origin)};
}

}  // namespace

SessionRecording::SessionRecording(const std::filesystem::path& file, const Scenario& scenario)
    : SessionRecording(std::make_unique<FileSink>(or_throw(FileSink::create(file))), scenario) {}

SessionRecording::SessionRecording(std::unique_ptr<ByteSink> sink, const Scenario& scenario)
    : recorder_(or_throw(Recorder::begin(
          std::move(sink),
          {.compression = scenario.recording.compression == "zstd" ? mcap::Compression::zstd
                                                                   : mcap::Compression::none,
           .wait_when_full = scenario.clock == "lockstep"}))),
      decoded_(scenario.recording.decoded),
      frames_(recorder_->add_topic({.topic = "/frames",
                                    .message_encoding = "json",
                                    .schema_name = "foverig.FrameRecord",
                                    .json_schema = frame_json_schema()})) {
    if (scenario.recording.decoded) {
        imu_ = recorder_->add_topic(imu_topic());
        gaze_ = recorder_->add_topic(gaze_topic());
    }
    recorder_->note(build_note());
    recorder_->attach(
        text_attachment(kScenarioAttachment, "application/toml", scenario_toml(scenario)));
    const std::string& file = scenario.tracking.gaze_calibration;
    if (!file.empty() && replayed_file(scenario).empty()) {
        std::ostringstream text;
        text << std::ifstream(file, std::ios::binary).rdbuf();
        recorder_->attach(text_attachment("calibration.json", "application/json", text.str()));
    }
}

void SessionRecording::begin(double initial_yaw_rad) {
    recorder_->note({.name = kSessionNote,
                     .texts = {{kInitialYaw, fmt::format("{}", initial_yaw_rad)},
                               {"log_time", "ns since the start of the run, host clock"}}});
}

Transport& SessionRecording::headset(Transport& device, const Clock& clock,
                                     std::optional<Origin> origin) {
    return headset_.emplace(device, *recorder_, clock,
                            RecordedDevice{.name = "dk2",
                                           .packet_encoding = "x-hid",
                                           .device_time = "report 11: u32 LE at byte 8, us, wraps",
                                           .origin = text_of(origin)});
}

Transport& SessionRecording::gaze_tracker(Transport& device, const Clock& clock,
                                          std::optional<Origin> origin) {
    return gaze_tracker_.emplace(
        device, *recorder_, clock,
        RecordedDevice{.name = "gaze",
                       .packet_encoding = "x-sgz1",
                       .device_time = "u64 LE at byte 16, ns: when given to USB",
                       .origin = text_of(origin)});
}

Transport& SessionRecording::tracker_camera(Transport& device, const Clock& clock,
                                            std::optional<Origin> origin) {
    if (decoded_) fixes_ = recorder_->add_topic(fix_topic());
    return tracker_camera_.emplace(device, *recorder_, clock, frames_of("camera", origin));
}

Transport& SessionRecording::see_through_camera(Transport& device, const Clock& clock,
                                                std::optional<Origin> origin) {
    return see_through_camera_.emplace(device, *recorder_, clock, frames_of("see_through", origin));
}

void SessionRecording::calibration(const dk2::FactoryCalibration& factory) {
    const dk2::GyroOffsets& offsets = factory.gyro_offsets;
    recorder_->note({.name = "foverig.calibration.dk2",
                     .texts = {{"accel_offset_m_s2", numbers(factory.accel_offset_m_s2)},
                               {"accel_from_raw_rows", numbers(factory.accel_from_raw)},
                               {"gyro_offset_rad_s", numbers(offsets.constant_rad_s())},
                               {"gyro_offsets_c_rad_s", numbers(offsets.stored())},
                               {"gyro_from_raw_rows", numbers(factory.gyro_from_raw)}}});
}

void SessionRecording::calibration(const gaze::Info& tracker) {
    recorder_->note(
        {.name = "foverig.calibration.gaze",
         .texts = {{"serial", tracker.serial},
                   {"firmware", tracker.firmware},
                   {"clock_hz", fmt::format("{}", tracker.clock_hz)},
                   {"nominal_latency_us", fmt::format("{}", tracker.nominal_latency_us)}}});
}

void SessionRecording::sample(const ImuSample& sample) {
    has_samples_ = true;
    if (!imu_) return;
    write_json(text_, sample);
    recorder_->record(*imu_, sample.arrival, sample.host_time, std::as_bytes(std::span(text_)));
}

void SessionRecording::sample(const GazeSample& sample) {
    has_samples_ = true;
    if (!gaze_) return;
    write_json(text_, sample);
    recorder_->record(*gaze_, sample.arrival, sample.host_time, std::as_bytes(std::span(text_)));
}

void SessionRecording::sample(const PoseFix& fix) {
    has_samples_ = true;
    if (!fixes_) return;
    write_json(text_, fix);
    recorder_->record(*fixes_, fix.arrival, fix.taken, std::as_bytes(std::span(text_)));
}

void SessionRecording::frames(const std::vector<FrameRecord>& frames, bool at_end) {
    const std::size_t may_change = at_end ? 0 : kFramesThatMayChange;
    while (frames_written_ + may_change < frames.size()) {
        const FrameRecord& frame = frames[frames_written_++];
        const std::string json = frame_json(frame);
        recorder_->record(frames_, frame.present, frame.present, std::as_bytes(std::span(json)));
    }
}

void SessionRecording::check() const {
    (void)or_throw(recorder_->status());
}

RecordingRecord SessionRecording::end() {
    (void)or_throw(recorder_->close());
    const RecorderCounts counts = recorder_->counts();
    return {.messages = counts.messages,
            .dropped = counts.dropped,
            .dropped_of = counts.dropped_of,
            .bytes = counts.bytes};
}

}  // namespace foverig
