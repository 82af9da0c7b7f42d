#pragma once
#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "rig/commands.h"

namespace foverig {

/// The options of `foverig tune`.
class TuneOptions {
  public:
    void add_to(CLI::App& app);
    TuneRequest request() const;

  private:
    std::string file_, out_;
    std::optional<double> budget_ms_;
    bool json_ = false;
};

}  // namespace foverig
