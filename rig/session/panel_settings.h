#pragma once
#include "rig/scenario/scenario.h"
#include "simulators/panel/virtual_panel.h"

namespace foverig {

// One seed for all, told apart so that the head's noise is not the eyes'.
enum class SeedStream : std::uint64_t { head = 1, eyes, panel, dk2, gaze, camera, worsening };

inline std::uint64_t seed_of(const Scenario& scenario, SeedStream stream) {
    return (static_cast<std::uint64_t>(stream) << 32U) | scenario.render.seed;
}

/// The scenario's virtual panel, whose first VSync is now.
inline VirtualPanel::Settings panel_settings(const Scenario& scenario, HostTime now) {
    return {.timing = PanelTiming::at(scenario.display.rate_hz),
            .first_vsync = now,
            .faults = scenario.faults.panel,
            .seed = seed_of(scenario, SeedStream::panel)};
}

}  // namespace foverig
