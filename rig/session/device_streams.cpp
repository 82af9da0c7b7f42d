#include "rig/session/device_streams.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "rig/failure.h"
#include "rig/session/calibration_file.h"
#include "rig/session/panel_settings.h"

namespace foverig {
namespace {

constexpr Nanoseconds kStep{10'000'000};

template <class Sample>
std::function<void(const Sample&)> sample_log(SessionRecording* recording) {
    if (recording == nullptr) return {};
    return [recording](const Sample& sample) { recording->sample(sample); };
}

GazeWorsening worsening_of(const Scenario& scenario) {
    return {.added_latency = from_seconds(1e-3 * scenario.tracking.gaze_added_latency_ms),
            .added_noise_deg = scenario.tracking.gaze_added_noise_deg,
            .seed = seed_of(scenario, SeedStream::worsening)};
}

/// A replayed device that cannot be opened since its file is damaged: that is what is said.
template <class Open>
auto opened_of(const World& world, Open open) {
    try {
        return open();
    } catch (const DeviceError&) {
        (void)world.at_end();  // throws InputError
        throw;
    }
}

}  // namespace

DeviceStreams::DeviceStreams(const Scenario& scenario, World& world, Clock& clock,
                             SessionRecording* recording, SeesThrough sees_through)
    : world_(world),
      clock_(clock),
      recording_(recording),
      head_(opened_of(world, [&] { return open_head(world); })),
      gaze_(opened_of(world, [&] { return open_gaze(scenario, world); })) {
    if (sees_through == SeesThrough::where_asked) open_see_through(scenario, world);
    if (recording_ == nullptr) return;
    recording_->calibration(head_.calibration());
    recording_->calibration(gaze_.info());
}

Transport& DeviceStreams::watched(const char* name, Transport& device) {
    return watched_.try_emplace(name, device, name, clock_, notice_).first->second;
}

HeadTracker DeviceStreams::open_head(World& world) {
    Transport* headset = &watched("dk2", world.headset());
    if (recording_ != nullptr) {
        recording_->begin(world.initial_yaw_rad());
        headset = &recording_->headset(*headset, clock_, first_origin(world, "dk2"));
    }
    Transport* camera = world.tracker_camera();
    if (camera != nullptr) camera = &watched("camera", *camera);
    if (camera != nullptr && recording_ != nullptr) {
        camera = &recording_->tracker_camera(*camera, clock_, first_origin(world, "camera"));
    }
    return {*headset, clock_.now(), HeadFusionConfig{.initial_yaw_rad = world.initial_yaw_rad()},
            sample_log<ImuSample>(recording_),
            CameraFeed{.transport = camera, .on_fix = sample_log<PoseFix>(recording_)}};
}

GazeTracker DeviceStreams::open_gaze(const Scenario& scenario, World& world) {
    Transport* tracker = &watched("gaze", world.gaze_tracker());
    if (recording_ != nullptr)
        tracker = &recording_->gaze_tracker(*tracker, clock_, first_origin(world, "gaze"));
    if (const GazeWorsening worsening = worsening_of(scenario); worsening.any())
        tracker = &worsened_gaze_.emplace(*tracker, clock_, worsening);
    return {*tracker, clock_, sample_log<GazeSample>(recording_), gaze_config(scenario)};
}

void DeviceStreams::open_see_through(const Scenario& scenario, World& world) {
    Transport* camera = world.see_through_camera();
    if (camera == nullptr) return;
    const char* name = "see_through";
    camera = &watched_.try_emplace(name, *camera, name, clock_, notice_, "nothing is seen through")
                  .first->second;
    if (recording_ != nullptr)
        camera =
            &recording_->see_through_camera(*camera, clock_, first_origin(world, "see_through"));
    see_through_.emplace(scenario.see_through, *camera);
}

std::vector<DeviceRecord> DeviceStreams::records() const {
    std::vector<DeviceRecord> records{head_.record(), gaze_.record()};
    if (const auto camera = head_.camera_record()) records.push_back(*camera);
    if (see_through_) records.push_back(see_through_->record());
    for (DeviceRecord& record : records) {
        record.outages = watched_.at(record.name).outages();
        record.origin = world_.origin(record.name);
        record.recorded_from = world_.recorded_from(record.name);
    }
    return records;
}

void DeviceStreams::tell(Notice notice) {
    notice_ = std::move(notice);
    told_of_camera_ = false;
    tell_of_camera();
}

/// Each time that it turns out so: a camera may come back as another than it was.
void DeviceStreams::tell_of_camera() {
    const Error* const problem = head_.camera_as_it_is();
    const bool told = std::exchange(told_of_camera_, problem != nullptr);
    if (!notice_ || problem == nullptr || told) return;
    const char* const lens =
        head_.camera_calibrated() ? "the lens that it told before" : "the design's lens";
    notice_(fmt::format("camera is not set up: it runs freely, with {} ({})", lens, problem->text));
}

void DeviceStreams::run_for(Nanoseconds duration) {
    const HostTime until = clock_.now() + duration;
    while (clock_.now() < until) {
        clock_.sleep_until(std::min(until, clock_.now() + kStep));
        read_until(clock_.now());
    }
}

void DeviceStreams::read_until(HostTime deadline) {
    head_.read_until(deadline);
    tell_of_camera();
    gaze_.read_until(deadline);
    if (see_through_) see_through_->read_until(deadline);
    if (recording_ != nullptr) recording_->check();
}

}  // namespace foverig
