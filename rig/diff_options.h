#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "rig/commands.h"

namespace foverig {

/// The options of `foverig diff`.
class DiffOptions {
  public:
    void add_to(CLI::App& app);
    DiffRequest request() const;

  private:
    std::string reference_, test_, out_, tone_mapper_ = "aces";
    double pixels_per_degree_ = 0.0, fovea_deg_ = 10.0, frames_per_s_ = 75.0;
    metrics::ScreenLight light_;
    std::vector<double> gaze_px_;
    std::vector<std::string> metrics_;
    bool json_ = false;
};

}  // namespace foverig
