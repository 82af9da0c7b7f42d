#pragma once
#include <CLI/CLI.hpp>
#include <string>

#include "rig/calibrate_command.h"
#include "rig/scenario_options.h"

namespace foverig {

/// The options of `foverig calibrate`.
class CalibrateOptions {
  public:
    void add_to(CLI::App& app);
    /// Throws UsageError.
    CalibrateRequest request() const;

  private:
    ScenarioOptions scenario_;
    int points_ = 5;
    double reach_deg_ = 16.0;
    bool validate_ = false;
    std::string out_ = "calibration.json";
};

}  // namespace foverig
