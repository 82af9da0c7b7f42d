#pragma once
// A DK2 tracker camera that is not there: frames of the headset's LEDs. One thread uses it.
#include <deque>

#include "devices/transport.h"
#include "simulators/camera/camera_registers.h"
#include "simulators/camera/camera_scene.h"
#include "simulators/dk2/led_light.h"
#include "simulators/motion/head_motion.h"

namespace foverig {

/// On a monitor before the head, looking at it slightly from above (own choice).
RigidPose usual_camera_place();

/// As SimulatedDk2: frames are made as time passes on `clock`. Set to the headset's pulses, one
/// frame comes of each flash; else the camera runs freely and sees what flashes happen to fall into
/// its exposures.
class SimulatedCamera final : public Transport {
  public:
    struct Settings {
        RigidPose world_from_camera = usual_camera_place();
        camera::Lens lens{};
        std::vector<dk2::Led> leds;
        CameraFaults faults{};
        std::uint64_t seed = 0;
        bool yuyv = false;  ///< frames as a kernel without the DK2's quirk gives them
    };

    /// All outlive the camera.
    SimulatedCamera(Clock& clock, const motion::HeadMotion& head, const LedLight& light,
                    Settings settings);

    NextPacket next(HostTime deadline) override;
    /// `id` is the extension unit's selector, `value` the unit.
    Status control_set(std::uint8_t id, std::uint16_t value,
                       std::span<const std::byte> data) override;
    Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t value,
                                               std::size_t size) override;

  private:
    struct Shot {
        HostTime start{};
        std::uint8_t pattern = 0;
        double share = 1.0;  ///< of a flash
        HostTime stamp{}, arrival{};
        std::uint32_t sequence = 0;
    };

    bool unplugged(HostTime now) const;
    void advance(HostTime now);
    void shoot(HostTime start, const std::optional<LedFlash>& flash);
    std::optional<HostTime> next_start() const;
    Packet developed(const Shot& shot);

    Clock& clock_;
    const motion::HeadMotion& head_;
    const LedLight& light_;
    Settings settings_;
    CameraScene scene_;
    CameraRegisters registers_;
    motion::Draws loss_;
    HostTime plugged_in_;
    HostTime last_start_;  // of the last exposure, or of the last pulse that was passed over
    HostTime busy_until_;  // a pulse before it is not heeded
    std::uint64_t shots_ = 0;
    std::deque<Shot> arriving_;
};

}  // namespace foverig
