#include "rig/session/world.h"

#include "rig/session/hardware_world.h"
#include "rig/session/replayed_world.h"
#include "rig/session/simulated_world.h"

namespace foverig {

std::unique_ptr<World> make_world(const Scenario& scenario, Clock& clock) {
    if (!replayed_file(scenario).empty()) return std::make_unique<ReplayedWorld>(scenario, clock);
    if (scenario.devices == "hardware") return std::make_unique<HardwareWorld>(scenario, clock);
    return std::make_unique<SimulatedWorld>(scenario, clock);
}

}  // namespace foverig
