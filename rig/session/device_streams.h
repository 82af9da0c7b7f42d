#pragma once
// The devices of a world, decoded, and recorded where a recording is given: what a run and
// `foverig record` share.
#include <map>

#include "rig/session/gaze_tracker.h"
#include "rig/session/head_tracker.h"
#include "rig/session/see_through.h"
#include "rig/session/session_recording.h"
#include "rig/session/watched_transport.h"
#include "rig/session/world.h"
#include "simulators/gaze/worsened_gaze.h"

namespace foverig {

class DeviceStreams {
  public:
    /// A see-through camera is opened only for those who show or record its frames.
    enum class SeesThrough { no, where_asked };

    /// Opens the devices as `scenario` asks; throws DeviceError where one does not answer.
    /// `recording` may be null; world, clock and recording outlive this. A recording holds what the
    /// gaze tracker sent, not what the scenario made worse of it.
    DeviceStreams(const Scenario& scenario, World& world, Clock& clock, SessionRecording* recording,
                  SeesThrough sees_through = SeesThrough::no);

    DeviceStreams(const DeviceStreams&) = delete;
    DeviceStreams& operator=(const DeviceStreams&) = delete;

    /// Hears at once of a camera that could not be set up, and from now on of each device that is
    /// lost, of each that is back, and of a camera that could be set up no more.
    void tell(Notice notice);

    /// Takes all that arrived until now in steps, for `duration`: clock maps and fusion settle.
    void run_for(Nanoseconds duration);
    /// Takes all that arrived by `deadline`. Throws where it could not be recorded.
    void read_until(HostTime deadline);

    HeadTracker& head() { return head_; }
    const GazeTracker& gaze() const { return gaze_; }
    /// Null: none.
    SeeThrough* see_through() { return see_through_ ? &*see_through_ : nullptr; }
    std::vector<DeviceRecord> records() const;

  private:
    HeadTracker open_head(World& world);
    GazeTracker open_gaze(const Scenario& scenario, World& world);
    void open_see_through(const Scenario& scenario, World& world);
    Transport& watched(const char* name, Transport& device);
    void tell_of_camera();

    const World& world_;
    Clock& clock_;
    SessionRecording* recording_;
    Notice notice_;
    bool told_of_camera_ = false;                      // that it is taken as it is
    std::map<std::string, WatchedTransport> watched_;  // by the devices' names
    std::optional<WorsenedGaze> worsened_gaze_;
    HeadTracker head_;
    GazeTracker gaze_;
    std::optional<SeeThrough> see_through_;
};

}  // namespace foverig
