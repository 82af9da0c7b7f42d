#pragma once
#include <string>

#include "rig/report/run_data.h"

namespace foverig::exports {

/// A run as a Perfetto trace (trace.pftrace; ui.perfetto.dev opens it): tracks of the sensors, the
/// frame's work, the wait for the VSync, the scan-out and the light, with an arrow for each frame
/// from the sensor sample through them to the photon; counters. On the run's clock, shifted so that
/// nothing is before 0.
std::string perfetto_trace(const report::RunData& run);

}  // namespace foverig::exports
