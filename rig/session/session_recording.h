#pragma once
// session.mcap: the devices' bytes, what they were decoded to, and the frames, while a run goes on.
#include <filesystem>

#include "devices/dk2/factory_calibration.h"
#include "devices/gaze/requests.h"
#include "devices/recording/fix_json.h"
#include "devices/recording/recorded_transport.h"
#include "devices/recording/sample_json.h"
#include "rig/records/run_record.h"
#include "rig/scenario/scenario.h"

namespace foverig {

inline constexpr const char* kSessionNote = "foverig.session";
inline constexpr const char* kInitialYaw = "initial_yaw_rad";
inline constexpr const char* kScenarioAttachment = "scenario.toml";

class SessionRecording {
  public:
    /// Begins the file with scenario and build. Throws std::runtime_error where it cannot be made.
    SessionRecording(const std::filesystem::path& file, const Scenario& scenario);
    /// The same into any sink.
    SessionRecording(std::unique_ptr<ByteSink> sink, const Scenario& scenario);

    /// Once, before the devices are opened: what a replay cannot know.
    void begin(double initial_yaw_rad);
    /// The devices, whose bytes are recorded from now on. All outlive the use of what is returned.
    /// `origin`: what the device is, or was before an earlier recording; none: nobody knows.
    Transport& headset(Transport& device, const Clock& clock, std::optional<Origin> origin);
    Transport& gaze_tracker(Transport& device, const Clock& clock, std::optional<Origin> origin);
    Transport& tracker_camera(Transport& device, const Clock& clock, std::optional<Origin> origin);
    Transport& see_through_camera(Transport& device, const Clock& clock,
                                  std::optional<Origin> origin);
    void calibration(const dk2::FactoryCalibration& factory);
    void calibration(const gaze::Info& tracker);

    void sample(const ImuSample& sample);
    void sample(const GazeSample& sample);
    void sample(const PoseFix& fix);
    /// Frames of a run so far: all but the newest few, which may yet change, or all at its end.
    void frames(const std::vector<FrameRecord>& frames, bool at_end);

    /// Throws std::runtime_error where something could not be written.
    void check() const;
    /// Whether a device has sent anything but answers.
    bool has_samples() const { return has_samples_; }
    /// So far.
    RecorderCounts counts() const { return recorder_->counts(); }
    RecordingRecord end();

  private:
    std::unique_ptr<Recorder> recorder_;
    bool decoded_;
    std::optional<Recorder::TopicId> imu_, gaze_, fixes_;  // none: left out
    Recorder::TopicId frames_;
    std::optional<RecordedTransport> headset_, gaze_tracker_, tracker_camera_, see_through_camera_;
    bool has_samples_ = false;
    std::size_t frames_written_ = 0;
    std::string text_;
};

}  // namespace foverig
