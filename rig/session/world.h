#pragma once
// Where the session's devices come from: models (SimulatedWorld), the desk (HardwareWorld) or a
// recording (ReplayedWorld).
#include <array>
#include <memory>
#include <optional>
#include <string_view>

#include "devices/display/display.h"
#include "devices/math.h"
#include "devices/transport.h"
#include "rig/records/run_record.h"
#include "rig/scenario/scenario.h"

namespace foverig {

class World {
  public:
    virtual ~World() = default;

    virtual Transport& headset() = 0;
    virtual Transport& gaze_tracker() = 0;
    virtual Display& display() = 0;
    /// The DK2's tracker camera; null: none is asked for, or none is there.
    virtual Transport* tracker_camera() = 0;
    /// A camera on the headset, opened when it is first asked for; null: none is asked for. Throws
    /// DeviceError where it cannot be opened, UsageError where a simulated one has no simulated
    /// head to sit on, InputError where a recording has none.
    virtual Transport* see_through_camera() = 0;

    /// Which way the head faces at the start, which no gravity shows.
    virtual double initial_yaw_rad() const = 0;
    /// What predictions are judged by; absent where nobody knows.
    virtual std::optional<dquat> true_head(HostTime time) const = 0;
    virtual std::optional<std::array<dvec3, 2>> true_gaze(HostTime time) const = 0;
    /// The truth or, in a replay, what the recorded tracker said of that instant.
    virtual std::optional<std::array<dvec3, 2>> best_known_gaze(HostTime time) const {
        return true_gaze(time);
    }

    /// Of "dk2", "gaze", "camera" or "see_through".
    virtual Origin origin(std::string_view device) const = 0;
    /// What a recorded one was when it was recorded; none: it is no recorded one, or its recording
    /// does not say.
    virtual std::optional<Origin> recorded_from(std::string_view) const { return std::nullopt; }
    /// The headset reads back the frames of this run's display, not those of another run.
    virtual bool reads_back_our_frames() const = 0;
    /// Nothing more will come. Throws InputError where the reason is a damaged file.
    virtual bool at_end() const = 0;
};

/// Simulated or hardware: what the device was before any recording; none: nobody knows.
std::optional<Origin> first_origin(const World& world, std::string_view device);

struct LiveParts;

/// What the scenario's `devices` asks for, with `live` the window it brings (null: none). Throws
/// UsageError for an unknown motion, InputError for a recording or trajectory that cannot be read,
/// DeviceError for a device that cannot be opened. `clock` outlives the world.
std::unique_ptr<World> make_world(const Scenario& scenario, Clock& clock,
                                  const LiveParts* live = nullptr);

}  // namespace foverig
