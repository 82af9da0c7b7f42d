#pragma once
// Everything that stands for hardware when `devices` is sim: a head, two eyes, a headset and a gaze
// tracker that speak bytes, a panel, and the truth to judge predictions by.
#include <array>
#include <memory>

#include "devices/time.h"
#include "rig/scenario/scenario.h"
#include "simulators/dk2/simulated_dk2.h"
#include "simulators/gaze/simulated_gaze.h"
#include "simulators/motion/eye_motion.h"
#include "simulators/motion/head_motion.h"
#include "simulators/panel/virtual_panel.h"

namespace foverig {

class SimulatedWorld {
  public:
    /// Throws UsageError for an unknown motion, InputError for a recording that cannot be read.
    /// `clock` outlives the world.
    SimulatedWorld(const Scenario& scenario, Clock& clock);

    Transport& headset() { return headset_; }
    Transport& gaze_tracker() { return gaze_tracker_; }
    Display& display() { return panel_; }

    dquat true_head(HostTime time) const;
    std::array<dvec3, 2> true_gaze(HostTime time) const;

  private:
    std::unique_ptr<motion::HeadMotion> head_;
    std::unique_ptr<motion::EyeMotion> eyes_;
    VirtualPanel panel_;
    SimulatedDk2 headset_;
    SimulatedGaze gaze_tracker_;
};

}  // namespace foverig
