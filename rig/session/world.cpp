#include "rig/session/world.h"

#include "rig/session/hardware_world.h"
#include "rig/session/replayed_world.h"
#include "rig/session/simulated_world.h"
#include "rig/session/windowed_world.h"

namespace foverig {
namespace {

std::unique_ptr<World> make_devices(const Scenario& scenario, Clock& clock,
                                    const motion::EyeMotion* pointed_eyes) {
    if (!replayed_file(scenario).empty()) return std::make_unique<ReplayedWorld>(scenario, clock);
    if (scenario.devices == "hardware")
        return std::make_unique<HardwareWorld>(scenario, clock, pointed_eyes);
    return std::make_unique<SimulatedWorld>(scenario, clock, pointed_eyes);
}

}  // namespace

std::optional<Origin> first_origin(const World& world, std::string_view device) {
    const Origin origin = world.origin(device);
    return origin == Origin::recorded ? world.recorded_from(device) : origin;
}

std::unique_ptr<World> make_world(const Scenario& scenario, Clock& clock, const LiveParts* live) {
    auto devices = make_devices(scenario, clock, live == nullptr ? nullptr : live->pointed_eyes);
    if (live == nullptr) return devices;
    // A simulated headset reads back the panel that is simulated with it, never a window.
    const bool real_headset = scenario.devices == "hardware" && !devices->reads_back_our_frames();
    return std::make_unique<WindowedWorld>(std::move(devices), live->make_display(clock),
                                           real_headset && scenario.display.kind == "headset");
}

}  // namespace foverig
