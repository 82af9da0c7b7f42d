#pragma once
#include <functional>
#include <memory>

#include "devices/math.h"
#include "devices/transport.h"
#include "rig/scenario/scenario.h"

namespace foverig {

/// The camera on the headset that is asked for; null: none. A simulated one sits on `true_head`.
/// Throws DeviceError where it cannot be opened. `clock` outlives it.
std::unique_ptr<Transport> open_see_through_camera(const SeeThroughSettings& asked, Clock& clock,
                                                   std::function<dquat(HostTime)> true_head);

}  // namespace foverig
