#pragma once
#include <CLI/CLI.hpp>
#include <string>

#include "rig/expose_command.h"
#include "rig/scenario_options.h"

namespace foverig {

/// The options of `foverig expose`.
class ExposeOptions {
  public:
    void add_to(CLI::App& app);
    ExposeRequest request() const;

  private:
    std::string device_, via_ = "usbip", record_;
    ScenarioOptions scenario_;
};

}  // namespace foverig
