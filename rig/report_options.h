#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "rig/commands.h"

namespace foverig {

/// The options of `foverig report`.
class ReportOptions {
  public:
    void add_to(CLI::App& app);
    ReportRequest request() const;

  private:
    std::vector<std::string> runs_, exports_;
    std::string together_;
};

}  // namespace foverig
